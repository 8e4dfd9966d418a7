#pragma once
#include <algorithm>
#include <cmath>

namespace touchstone::vnv {

/// Times agree to nine digits, since a run may reach 0.1 s in many steps; two that are not numbers agree.
inline bool same_time(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

}  // namespace touchstone::vnv
