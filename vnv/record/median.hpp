#pragma once
#include <algorithm>
#include <limits>
#include <vector>

namespace touchstone::vnv {

/// The middle one, or the mean of the two in the middle; not a number if there is none.
inline double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::ranges::sort(values);
  const std::size_t last = values.size() - 1;
  return (values[last / 2] + values[last - last / 2]) / 2;
}

}  // namespace touchstone::vnv
