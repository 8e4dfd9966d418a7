#include "vnv/record/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::vnv {

std::string in_digits_of_interval(double value, double half_width) {
  const double last_digit = std::pow(10, std::floor(std::log10(std::abs(value))) - 3);
  half_width = std::max(half_width, last_digit);
  const double digits = std::floor(std::log10(half_width));
  if (!(digits >= -9 && digits <= 3)) return fmt::format("{:.3g} ± {:.1g}", value, half_width);
  const int places =
      std::max(0, static_cast<int>(-digits) + (half_width > last_digit && half_width < 3 * std::pow(10, digits)));
  return fmt::format("{:.{}f} ± {:.{}f}", value, places, half_width, places);
}

std::string in_digits(const FittedCause& cause) {
  if (cause.unit.empty()) return "";
  return cause.half_width == 0 ? fmt::format("{:.4g}", cause.value)
                               : in_digits_of_interval(cause.value, cause.half_width);
}

}  // namespace touchstone::vnv
