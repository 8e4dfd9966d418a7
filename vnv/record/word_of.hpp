#pragma once
#include <cstddef>
#include <string_view>

namespace touchstone::vnv {

/// The word for an enumerator: `words(value)` lists those of all, in the order of the enumerators.
constexpr std::string_view word_of(auto value) { return words(value).at(static_cast<std::size_t>(value)); }

}  // namespace touchstone::vnv
