#include "vnv/judge/grid_convergence.hpp"

#include "vnv/record/quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

namespace touchstone::vnv {
namespace {

using Approach = GridConvergence::Trend;

constexpr double safety = 1.25;  // Roache (1998), for an order that was observed over three resolutions

/// The differences of f = f0 + c h^p between three spacings, the coarse over the fine one: rises with p.
struct RatioOfDifferences {
  double coarser, finer;  // of spacings, coarse / middle and middle / fine; above 1

  double operator()(double p) const {
    return p == 0 ? std::log(coarser) / std::log(finer)
                  : std::pow(finer, p) * std::expm1(p * std::log(coarser)) / std::expm1(p * std::log(finer));
  }
};

/// Where the ratio is the one seen. Throws nothing: a ratio that no order up to `steepest` has is that of the steepest.
double order_of(const RatioOfDifferences& ratio, double seen) {
  constexpr double steepest = 100;
  if (ratio(steepest) <= seen) return steepest;
  auto difference = [&](double p) { return ratio(p) - seen; };
  const auto call = [](double p, void* of) { return (*static_cast<decltype(difference)*>(of))(p); };
  gsl_function called{call, &difference};
  const auto release = [](gsl_root_fsolver* solver) { gsl_root_fsolver_free(solver); };
  const std::unique_ptr<gsl_root_fsolver, decltype(release)> search(gsl_root_fsolver_alloc(gsl_root_fsolver_brent),
                                                                    release);
  gsl_root_fsolver_set(search.get(), &called, 0, steepest);
  for (int k = 0; k < 200; ++k) {
    gsl_root_fsolver_iterate(search.get());
    const double low = gsl_root_fsolver_x_lower(search.get()), high = gsl_root_fsolver_x_upper(search.get());
    if (gsl_root_test_interval(low, high, 1e-13, 1e-13) == GSL_SUCCESS) break;
  }
  return gsl_root_fsolver_root(search.get());
}

void require_ladder(const std::vector<AtSpacing>& levels) {
  std::vector<std::string> spacings;
  bool is_ladder = true;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    spacings.push_back(fmt::format("{:g}", levels[k].spacing));
    is_ladder &= levels[k].spacing > 0 && std::isfinite(levels[k].spacing) &&
                 (k == 0 || levels[k].spacing < levels[k - 1].spacing);
  }
  if (!is_ladder)
    throw std::invalid_argument(
        fmt::format("grid convergence: spacings {}, expected positive and decreasing ones", fmt::join(spacings, ", ")));
  for (const AtSpacing& level : levels)
    if (!std::isfinite(level.value))
      throw std::invalid_argument(fmt::format("grid convergence: value {} at spacing {:g}, expected a finite number",
                                              level.value, level.spacing));
}

/// How far the value at the finer spacing is from the limit of a law of this order.
double distance_to_limit(const AtSpacing& coarser, const AtSpacing& finer, double order) {
  return std::abs((coarser.value - finer.value) / std::expm1(order * std::log(coarser.spacing / finer.spacing)));
}

double range_of(const std::vector<AtSpacing>& ladder) {
  const auto [least, largest] = std::ranges::minmax(ladder, {}, &AtSpacing::value);
  return largest.value - least.value;
}

}  // namespace

GridConvergence grid_convergence(const AtSpacing& coarse, const AtSpacing& middle, const AtSpacing& fine) {
  require_ladder({coarse, middle, fine});
  const double last = middle.value - fine.value, before = coarse.value - middle.value;
  if (last == 0) return {before == 0 ? Approach::constant : Approach::monotone, not_a_number, fine.value, 0};
  const double seen = before / last;
  if (seen <= 0)
    return {before == 0 ? Approach::diverging : Approach::oscillating, not_a_number, not_a_number, not_a_number};
  const RatioOfDifferences ratio{coarse.spacing / middle.spacing, middle.spacing / fine.spacing};
  if (seen <= ratio(0)) return {Approach::diverging, not_a_number, not_a_number, not_a_number};
  const double p = order_of(ratio, seen), to_limit = last / std::expm1(p * std::log(ratio.finer));
  return {Approach::monotone, p, fine.value - to_limit, safety * std::abs(to_limit)};
}

NumericalUncertainty numerical_uncertainty(const std::vector<AtSpacing>& ladder, double formal_order) {
  constexpr double safety_of_two = 3, safety_of_a_range = 3, lowest_order = 0.5, highest_order = 2;
  constexpr double of_known_sign = 1.15, of_either_sign = 2;  // the interval by its standard uncertainty
  require_ladder(ladder);
  if (!(formal_order > 0))
    throw std::invalid_argument(
        fmt::format("numerical uncertainty: formal order {}, expected a positive number", formal_order));
  const std::size_t count = ladder.size();
  if (count < 2) return {not_a_number, not_a_number, "one resolution"};
  const auto from = [](double interval, double divisor, std::string basis) {
    return NumericalUncertainty{interval / divisor, interval, std::move(basis)};
  };
  const AtSpacing &middle = ladder[count - 2], &fine = ladder[count - 1];
  if (count == 2)
    return from(safety_of_two * distance_to_limit(middle, fine, formal_order), of_known_sign,
                fmt::format("two resolutions, assumed of order {:g}, factor 3", formal_order));
  const GridConvergence found = grid_convergence(ladder[count - 3], middle, fine);
  if (found.trend == Approach::monotone && found.order > highest_order * formal_order)
    return from(safety_of_two * distance_to_limit(ladder[count - 3], fine, formal_order), of_known_sign,
                fmt::format("first and last of three resolutions, assumed of order {:g}, factor 3, as the finest two "
                            "agree by chance",
                            formal_order));
  if (found.trend == Approach::monotone && found.order >= lowest_order) {
    const double order = std::min(found.order, formal_order);
    return from(safety * distance_to_limit(middle, fine, order), of_known_sign,
                fmt::format("grid convergence index, observed order {:.2f}{}", found.order,
                            order < found.order ? fmt::format(", taken as {:g}", order) : ""));
  }
  return from(safety_of_a_range * range_of(ladder), of_either_sign,
              fmt::format("3 times the range of {} resolutions, as the order is unclear", count));
}

}  // namespace touchstone::vnv
