#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace touchstone::vnv {

/// Times agree to nine digits, since a run may reach 0.1 s in many steps; two that are not numbers agree.
inline bool same_time(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

/// A time as it was meant: 0.05, of which 0.05 * H * H / nu is off by its last digit.
inline double as_meant(double time) {
  const double rounded = std::stod(fmt::format("{:.14g}", time));
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  return std::abs(rounded - time) <= rounding * std::abs(time) ? rounded : time;
}

}  // namespace touchstone::vnv
