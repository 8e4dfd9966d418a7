#pragma once
/// What a person sees: colours and lines as wide as a terminal, plain text everywhere else.

#include <string>
#include <string_view>

namespace touchstone::vnv::command {

enum class Colour { red = 31, green = 32, yellow = 33, bold = 1 };

/// The text in a colour if stdout is a terminal, unless NO_COLOR (no-color.org) is set or TERM is `dumb`.
std::string coloured(Colour colour, std::string_view text);

/// Columns of the terminal, at least 40; 100 if stdout is none.
int width();

/// Paragraphs broken at spaces into lines of so many columns, each with an indent. Bytes that continue a character of
/// UTF-8 take no column; a word that is longer than a line stands alone.
std::string wrapped(std::string_view text, int columns, int indent = 0);

}  // namespace touchstone::vnv::command
