#include "reports/text/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/trim.hpp>
#include <regex>

namespace touchstone::reports {
namespace {

std::string row_html(const HtmlRow& cells, std::string_view tag) {
  std::string html;
  for (const auto& cell : cells)
    html += fmt::format("<{0}{1}{2}>{3}</{0}>", tag, cell.kind.empty() ? "" : " class=\"" + cell.kind + "\"",
                        cell.rows == 1 ? "" : fmt::format(" rowspan=\"{}\"", cell.rows), cell.html);
  return fmt::format("<tr>{}</tr>\n", html);
}

HtmlRow head(const HtmlTable& table) {
  HtmlRow cells;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const bool is_of_numbers = std::ranges::any_of(
        table.rows, [&](const HtmlRow& row) { return row.size() == table.columns.size() && row[i].is_number(); });
    cells.emplace_back(table.columns[i], is_of_numbers ? "number" : "");
  }
  return cells;
}

}  // namespace

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
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

std::string typeset(std::string_view text) {
  return with_symbols(replaced(escape(text), " %", "\u202f%"), "<i>$1</i><sub>$2</sub>", "<sup>$1</sup>");
}

std::string breakable(std::string_view name) {
  static const std::regex within(R"(_(?=.)|[a-z](?=[A-Z]))");
  return std::regex_replace(escape(name), within, "$&<wbr>");
}

std::string paragraphs(std::string_view text) {
  static const std::regex blank_lines(R"(\n([ \t\r]*\n)+)");
  const std::string whole = boost::algorithm::trim_copy(std::string(text));
  return whole.empty() ? "" : fmt::format("<p>{}</p>\n", std::regex_replace(typeset(whole), blank_lines, "</p>\n<p>"));
}

std::string html_list(std::string_view kind, const std::string& items) {
  return items.empty() ? "" : fmt::format("<ul class=\"{}\">\n{}</ul>\n", kind, items);
}

std::string to_html(const HtmlTable& table) {
  if (table.rows.empty()) return "";
  std::string body;
  for (const auto& cells : table.rows) body += row_html(cells, "td");
  return fmt::format(
      "<div class=\"table{}\">\n<p class=\"caption\"><b>{}</b> {}</p>\n"
      "<div class=\"scroll\" "
      "tabindex=\"0\">\n<table>\n<thead>\n{}</thead>\n<tbody>\n{}</tbody>\n</table>\n</div>\n</div>\n",
      table.kind.empty() ? "" : " " + table.kind, table.title, table.caption, row_html(head(table), "th"), body);
}

std::string html_page(std::string_view title, std::string_view root, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title>\n<link rel=\"stylesheet\" href=\"{1}style.css\">\n<script src=\"{1}site.js\" defer></script>\n</head>\n<body>\n{2}</body>\n</html>\n",
      escape(title), root, body);
}

std::string html_page_beside_index(std::string_view title, std::string_view path, std::string_view sum,
                                   std::string_view body, std::string_view main_attributes) {
  return html_page(title, "",
                   fmt::format("<main{}>\n<header>\n<p class=\"path\"><a href=\"index.html\">Touchstone</a> / {}</p>\n"
                               "<h1>{}</h1>\n{}</header>\n{}</main>\n",
                               main_attributes, path, title, sum, body));
}

}  // namespace touchstone::reports
