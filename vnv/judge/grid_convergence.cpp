#include "vnv/judge/grid_convergence.hpp"

#include "vnv/record/quantity.hpp"

#include <fmt/format.h>
#include <gsl/gsl_roots.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

using Approach = GridConvergence::Trend;

constexpr double safety = 1.25;  // Roache (1994), for an order that was observed over three resolutions

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

void require_ladder(const AtSpacing& coarse, const AtSpacing& middle, const AtSpacing& fine) {
  if (!(fine.spacing > 0 && middle.spacing > fine.spacing && coarse.spacing > middle.spacing &&
        std::isfinite(coarse.spacing)))
    throw std::invalid_argument(
        fmt::format("grid convergence: spacings {:g}, {:g}, {:g}, expected positive and falling", coarse.spacing,
                    middle.spacing, fine.spacing));
  for (const AtSpacing& level : {coarse, middle, fine})
    if (!std::isfinite(level.value))
      throw std::invalid_argument(fmt::format("grid convergence: value {} at spacing {:g}, expected a finite number",
                                              level.value, level.spacing));
}

}  // namespace

GridConvergence grid_convergence(const AtSpacing& coarse, const AtSpacing& middle, const AtSpacing& fine) {
  require_ladder(coarse, middle, fine);
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

}  // namespace touchstone::vnv
