#include "vnv/gate/compare_orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace touchstone::gate {
namespace {

bool is_of_rounding(const vnv::ObservedOrder& order) {
  return std::ranges::all_of(order.errors, [](double error) { return std::abs(error) <= rounding_of_zero; });
}

/// Whether the interval of the lower order ends below that of the higher one; not where one is unknown or infinite.
bool are_apart(const vnv::ObservedOrder& a, const vnv::ObservedOrder& b) {
  return std::abs(a.order - b.order) > a.half_width + b.half_width;
}

}  // namespace

double tilt_by(double fraction, const std::vector<double>& spacings) {
  std::vector<double> x;
  for (const double spacing : spacings) x.push_back(std::log(spacing));
  const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
  double sum = 0, squares = 0;
  for (const double value : x) {
    sum += std::abs(value - mean);
    squares += (value - mean) * (value - mean);
  }
  return squares > 0 ? fraction * sum / squares : 0;
}

Reason compare_orders(const vnv::ObservedOrder& before, const vnv::ObservedOrder& after, double explained) {
  if (!before.errors.empty() && is_of_rounding(before) && is_of_rounding(after))
    return {Change::same, "errors are rounding and have no order"};
  if (!std::isfinite(before.order) || !std::isfinite(after.order))
    return compare_values(before.order, after.order, vnv::Better::larger, 0);
  const double rise = after.order - before.order;
  const std::string why =
      fmt::format("by {:+.3g}, intervals +- {:.2g} and +- {:.2g}", rise, before.half_width, after.half_width);
  constexpr double rounding = 1e-9;  // a fall by 0.3 may come as 0.29999999999999998
  if (rise <= -noticed_fall + rounding) return {Change::worse, why};
  if (std::abs(rise) <= std::max(same_order, explained) + rounding) return {Change::same, why};
  const bool are_told = std::isfinite(before.half_width) && std::isfinite(after.half_width);  // by more than two points
  if (rise > 0 && !are_told) return {Change::unjudged, why};
  if (rise >= noticed_fall || (rise > 0 && are_apart(before, after))) return {Change::better, why};
  if (rise > 0) return {Change::same, why};
  return {are_apart(before, after) ? Change::worse : Change::inconclusive, why};
}

}  // namespace touchstone::gate
