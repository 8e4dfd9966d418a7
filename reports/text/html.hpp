#pragma once
/// Text as HTML: what templates make of it.

#include <string>
#include <string_view>

namespace touchstone::reports {

/// Every `from` replaced by `to`.
std::string replaced(std::string text, std::string_view from, std::string_view to);

/// The symbols and powers of a text, as records write them, in another notation: v_x has an index, 10^-3 a power; the
/// method mpm_reset has neither. `symbol` and `power` are what std::regex_replace puts for them: $1 is the letter or
/// the exponent, $2 the index. A backslash before _ or ^ may stand for the escape of that notation.
std::string with_symbols(const std::string& text, const std::string& symbol, const std::string& power);

/// Text as HTML shows it: & < > " and ' are spelled out.
std::string escape(std::string_view text);

// What templates ask for by sections of these names, of text that is escaped.

/// Symbols as in print, and no break before a %.
std::string typeset(std::string_view html);

/// Numbers as `printed` writes them: powers of ten get exponents, and what is not finite is marked where it begins an
/// element or follows a sign of an interval.
std::string numbers(std::string_view html);

/// A name that may break after an underscore and before a capital.
std::string breakable(std::string_view html);

/// Typeset paragraphs; blank lines part them.
std::string paragraphs(std::string_view html);

}  // namespace touchstone::reports
