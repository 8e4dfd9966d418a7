#include "reports/figures/plot.hpp"

#include "reports/text/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace touchstone::reports {
std::string gnuplot_string(std::string_view text) {
  std::string quoted;
  for (const char letter : text) {
    if (letter == '\'') quoted += '\'';
    quoted += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
  }
  return "'" + quoted + "'";
}

// A backslash keeps a letter from being taken for a command; a last space would be lost before a symbol.
std::string gnuplot_label(std::string_view text) {
  static const std::regex commands(R"([\\{}@&~_^])");
  const std::string escaped = std::regex_replace(std::string(text), commands, R"(\$&)");
  return replaced(with_symbols(escaped, "{/:Italic $1}_{$2}", "^{$1}"), " {/:", "\u00a0{/:");
}

std::string data_rows(const std::string& figure, std::size_t first, std::size_t count) {
  return fmt::format("'{}.csv' skip 1 every ::{}::{} using ", figure, first, first + count - 1);
}

std::size_t place_in(std::vector<std::string>& names, const std::string& name) {
  const auto place = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  if (place == names.size()) names.push_back(name);
  return place;
}

}  // namespace touchstone::reports
