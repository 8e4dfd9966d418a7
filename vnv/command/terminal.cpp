#include "vnv/command/terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace touchstone::vnv::command {
namespace {

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool has_colours() {
  static const bool is_dumb = is_set("TERM") && std::string_view(std::getenv("TERM")) == "dumb",
                    has = isatty(STDOUT_FILENO) != 0 && !is_set("NO_COLOR") && !is_dumb;
  return has;
}

int columns_taken(std::string_view word) {
  return static_cast<int>(std::ranges::count_if(word, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

}  // namespace

std::string coloured(Colour colour, std::string_view text) {
  if (!has_colours()) return std::string(text);
  return fmt::format("\x1b[{}m{}\x1b[0m", static_cast<int>(colour), text);
}

int width() {
  winsize size{};  // asked of what is no terminal, the call fails
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? std::max<int>(size.ws_col, 40) : 100;
}

std::string wrapped(std::string_view text, int columns, int indent) {
  const std::string margin(static_cast<std::size_t>(indent), ' ');
  std::string lines;
  std::istringstream paragraphs{std::string(text)};
  for (std::string paragraph; std::getline(paragraphs, paragraph);) {
    int taken = 0;
    std::istringstream words(paragraph);
    for (std::string word; words >> word;) {
      const bool fits = taken > 0 && taken + 1 + columns_taken(word) <= columns;
      lines += fits ? " " : taken > 0 ? "\n" + margin : margin;
      taken = (fits ? taken + 1 : indent) + columns_taken(word);
      lines += word;
    }
    lines += '\n';
  }
  return lines;
}

}  // namespace touchstone::vnv::command
