#pragma once
/// The two error norms by which every case is judged; no case defines its own.

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string_view>

namespace touchstone::vnv {

using Values = std::span<const double>;

namespace norms {

inline void require_same_size(std::string_view norm, std::string_view name, Values values, Values exact) {
  if (values.size() == exact.size() && !exact.empty()) return;
  throw std::invalid_argument(
      fmt::format("{}: {} {} values and {} exact values, expected equally many and at least one", norm, values.size(),
                  name, exact.size()));
}

inline void require_scale(std::string_view norm, double scale) {
  if (scale != 0) return;  // not a number is no refusal: it has to reach the verdict
  throw std::invalid_argument(
      fmt::format("{}: the exact values are all zero, expected one with a weight that is not", norm));
}

inline void require_no_negative(std::string_view norm, Values weights) {
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i] < 0)
      throw std::invalid_argument(fmt::format("{}: weight {} = {}, expected zero or more", norm, i, weights[i]));
}

/// The larger magnitude; unlike `std::max` it never forgets a value that is not a number.
inline double larger_magnitude(double largest, double value) {
  const double magnitude = std::abs(value);
  return std::isnan(largest) || magnitude <= largest ? largest : magnitude;
}

}  // namespace norms

/// Relative L2 norm of the error, Sun et al. (34) with its root: sqrt(sum w (e - n)² / sum w e²).
/// Equally long values of one unit and weights >= 0 of any unit; not a number in any of them gives not a number.
/// Throws std::invalid_argument for no values, unequal sizes, a negative weight, or a truth that is zero everywhere.
inline double relative_l2(Values numerical, Values exact, Values weights) {
  norms::require_same_size("relative_l2", "numerical", numerical, exact);
  norms::require_same_size("relative_l2", "weight", weights, exact);
  norms::require_no_negative("relative_l2", weights);
  double error = 0, scale = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const double miss = exact[i] - numerical[i];
    error += weights[i] * miss * miss;
    scale += weights[i] * exact[i] * exact[i];
  }
  norms::require_scale("relative_l2", scale);
  return std::sqrt(error / scale);
}

/// Relative maximum norm of the error, Sun et al. (35): max|e - n| / max|e|.
/// Equally long values of one unit; not a number in any of them gives not a number.
/// Throws std::invalid_argument for no values, unequal sizes, or a truth that is zero everywhere.
inline double relative_linf(Values numerical, Values exact) {
  norms::require_same_size("relative_linf", "numerical", numerical, exact);
  double error = 0, scale = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    error = norms::larger_magnitude(error, exact[i] - numerical[i]);
    scale = norms::larger_magnitude(scale, exact[i]);
  }
  norms::require_scale("relative_linf", scale);
  return error / scale;
}

}  // namespace touchstone::vnv
