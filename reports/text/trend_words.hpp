#pragma once
/// Trends of errors, told alike on all pages: by a sign, a word and a colour.

#include "reports/text/html.hpp"
#include "vnv/record/record.hpp"

#include <string>

namespace touchstone::reports {

/// The class by which the style sheet knows the colour; also the word.
inline std::string word(vnv::Trend trend) { return std::string(vnv::name_of(trend)); }

/// "↘ converging": where the errors go as the spacing shrinks.
inline std::string sign_and_word(vnv::Trend trend) {
  const char* sign = trend == vnv::Trend::converging  ? "↘"
                     : trend == vnv::Trend::stalled   ? "→"
                     : trend == vnv::Trend::diverging ? "↗"
                                                      : "?";
  return sign + std::string("\u00a0") + word(trend);
}

}  // namespace touchstone::reports
