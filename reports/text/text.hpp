#pragma once
/// Symbols inside plain text, as records write them: v_x has an index, 10^-3 a power; the method mpm_reset has neither.

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::reports {

/// Either plain text, or a letter with its index, or a power of what stands before it.
struct Piece {
  enum class Kind { plain, symbol, power } kind;
  std::string text;     // of a power: its exponent
  std::string index{};  // of a symbol
};
std::vector<Piece> pieces(std::string_view text);

/// Every `from` replaced by `to`.
std::string replaced(std::string text, std::string_view from, std::string_view to);

}  // namespace touchstone::reports
