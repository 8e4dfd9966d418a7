#include "vnv/judge/order.hpp"

#include "vnv/judge/error_law.hpp"

#include <fmt/format.h>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace touchstone::vnv {
namespace {

/// Not a number for an error through which no power law passes.
double log_of(double value) { return value > 0 && std::isfinite(value) ? std::log(value) : not_a_number; }

std::vector<double> logs(const std::vector<double>& values) {
  std::vector<double> result;
  for (const double value : values) result.push_back(log_of(value));
  return result;
}

std::vector<double> slopes(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> result;
  for (std::size_t i = 1; i < x.size(); ++i) result.push_back((y[i] - y[i - 1]) / (x[i] - x[i - 1]));
  return result;
}

/// Half-width of the 95 % interval of a fitted slope.
double half_width(std::size_t points, double slope, double variance) {
  if (std::isnan(slope)) return not_a_number;
  if (points == 2) return std::numeric_limits<double>::infinity();
  return gsl_cdf_tdist_Pinv(0.975, static_cast<double>(points - 2)) * std::sqrt(variance);
}

/// Takes a floor where the law with one is better than chance makes it.
void find_floor(const std::vector<double>& spacings, const std::vector<double>& errors, double squares_of_line,
                ObservedOrder& found) {
  const auto law = fit_law_with_floor(spacings, errors);
  if (!law) return;
  const double freedom = static_cast<double>(errors.size() - 3);
  const bool by_chance =
      (squares_of_line - law->squares) * freedom < gsl_cdf_fdist_Pinv(0.95, 1, freedom) * law->squares;
  const bool is_sure = law->floor_half_width <= law->floor / 2, matters = law->floor > 0.01 * errors.back();
  if (by_chance || !is_sure || !matters) return;
  found.floor = law->floor;
  found.floor_half_width = law->floor_half_width;
  found.order_to_floor = law->order;
  found.order_to_floor_half_width = law->order_half_width;
}

/// Orders of neighbouring levels above the floor, if there is one.
std::vector<double> pairs_above_floor(const std::vector<double>& log_spacings, std::vector<double> errors,
                                      const ObservedOrder& found) {
  if (std::isnan(found.floor)) return found.pairwise;
  for (double& error : errors) error -= found.floor;
  return slopes(log_spacings, logs(errors));
}

bool is_asymptotic(const std::vector<double>& pairs, double order) {
  return pairs.size() >= 2 && std::abs(pairs.end()[-1] - order) <= 0.1 * std::abs(order) &&
         std::abs(pairs.end()[-2] - order) <= 0.1 * std::abs(order);
}

Trend trend_of(const ObservedOrder& found, const std::vector<double>& errors) {
  const double low = found.order - found.half_width, high = found.order + found.half_width;
  const bool has_floor = !std::isnan(found.floor);
  if ((has_floor && found.floor > errors.back() / 2) || (low > -0.5 && high < 0.5)) return Trend::stalled;
  if (high < 0) return Trend::diverging;
  if (has_floor ? found.order_to_floor > found.order_to_floor_half_width : low > 0) return Trend::converging;
  return Trend::inconclusive;
}

/// Throws std::invalid_argument unless the spacings [m] of a ladder are finite, positive and falling.
void require_falling(const std::vector<double>& spacings) {
  double coarser = std::numeric_limits<double>::infinity();
  for (const double spacing : spacings) {
    if (!(spacing > 0 && spacing < coarser))
      throw std::invalid_argument(
          fmt::format("observe_order: spacing {} m after {} m, expected finite, positive and decreasing spacings",
                      spacing, coarser));
    coarser = spacing;
  }
}

}  // namespace

ObservedOrder observe_order(std::vector<double> spacings, std::vector<double> errors) {
  if (spacings.size() != errors.size())
    throw std::invalid_argument(
        fmt::format("observe_order: {} spacings and {} errors, expected equally many", spacings.size(), errors.size()));
  require_falling(spacings);
  const auto x = logs(spacings), y = logs(errors);
  ObservedOrder found;
  found.pairwise = slopes(x, y);
  if (x.size() >= 2) {
    double intercept, intercept_variance, covariance, variance, residual;
    gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &intercept, &found.order, &intercept_variance, &covariance,
                   &variance, &residual);
    found.half_width = half_width(x.size(), found.order, variance);
    find_floor(spacings, errors, residual, found);
    found.trend = trend_of(found, errors);
    found.asymptotic = is_asymptotic(pairs_above_floor(x, errors, found),
                                     std::isnan(found.floor) ? found.order : found.order_to_floor);
  }
  found.spacings = std::move(spacings);
  found.errors = std::move(errors);
  return found;
}

}  // namespace touchstone::vnv
