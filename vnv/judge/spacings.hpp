#pragma once
#include <fmt/format.h>

#include <limits>
#include <span>
#include <stdexcept>
#include <string_view>

namespace touchstone::vnv {

/// Throws std::invalid_argument unless the spacings [m] of a ladder are finite, positive and falling.
inline void require_falling(std::string_view owner, std::span<const double> spacings) {
  double coarser = std::numeric_limits<double>::infinity();
  for (const double spacing : spacings) {
    if (!(spacing > 0 && spacing < coarser))
      throw std::invalid_argument(fmt::format(
          "{}: spacing {} m after {} m, expected finite, positive and falling spacings", owner, spacing, coarser));
    coarser = spacing;
  }
}

}  // namespace touchstone::vnv
