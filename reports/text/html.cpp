#include "reports/text/html.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <regex>
#include <utility>

namespace touchstone::reports {

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  boost::algorithm::replace_all(text, from, to);
  return text;
}

std::string with_symbols(const std::string& text, const std::string& symbol, const std::string& power) {
  if (text.find_first_of("_^") == std::string::npos) return text;
  static const std::regex symbols(R"(\b([A-Za-z])\\?_([A-Za-z0-9]+))"),
      negative_powers(R"(\\?\^-([A-Za-z0-9]+(?:\.[A-Za-z0-9]+)*))"),
      powers(R"(\\?\^([A-Za-z0-9]+(?:\.[A-Za-z0-9]+)*))");
  const std::string with_indices = std::regex_replace(text, symbols, symbol);
  return std::regex_replace(std::regex_replace(with_indices, negative_powers, replaced(power, "$1", "−$1")), powers,
                            power);
}

std::string escape(std::string_view text) {
  std::string html(text);
  for (const auto& [letter, spelled] :
       {std::pair{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}, {"'", "&#39;"}})
    html = replaced(html, letter, spelled);
  return html;
}

std::string typeset(std::string_view html) {
  return with_symbols(replaced(std::string(html), " %", "\u202f%"), "<i>$1</i><sub>$2</sub>", "<sup>$1</sup>");
}

std::string numbers(std::string_view html) {
  static const std::regex powers("(×\u202f10)\\^(-?)([0-9]+)"),
      not_finite("(^|>|± |–)(nan|(?:−)?inf)(?=$|<|\u202f| ±|–)");
  std::string set(html);
  if (set.find("10^") != std::string::npos)
    set = replaced(std::regex_replace(set, powers, "$1<sup>$2$3</sup>"), "<sup>-", "<sup>−");
  if (set.find("nan") != std::string::npos || set.find("inf") != std::string::npos)
    set = std::regex_replace(set, not_finite, "$1<span class=\"nan\">$2</span>");
  return set;
}

std::string breakable(std::string_view html) {
  static const std::regex within(R"(_(?=.)|[a-z](?=[A-Z]))");
  return std::regex_replace(std::string(html), within, "$&<wbr>");
}

std::string paragraphs(std::string_view html) {
  static const std::regex blank_lines(R"(\n([ \t\r]*\n)+)");
  const std::string whole = boost::algorithm::trim_copy(std::string(html));
  return whole.empty() ? "" : "<p>" + std::regex_replace(typeset(whole), blank_lines, "</p>\n<p>") + "</p>\n";
}

}  // namespace touchstone::reports
