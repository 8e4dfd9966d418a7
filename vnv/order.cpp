#include "vnv/order.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace touchstone::vnv {
namespace {

void require_falling(const std::vector<double>& spacings, std::size_t errors) {
  if (spacings.size() != errors)
    throw std::invalid_argument(
        fmt::format("observe_order: {} spacings and {} errors, wanted equally many", spacings.size(), errors));
  double coarser = std::numeric_limits<double>::infinity();
  for (const double spacing : spacings) {
    if (!(spacing > 0 && spacing < coarser))
      throw std::invalid_argument(fmt::format(
          "observe_order: spacing {} m after {} m, wanted finite, positive and falling spacings", spacing, coarser));
    coarser = spacing;
  }
}

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

}  // namespace

ObservedOrder observe_order(std::vector<double> spacings, std::vector<double> errors) {
  require_falling(spacings, errors.size());
  const auto x = logs(spacings), y = logs(errors);
  ObservedOrder found;
  found.pairwise = slopes(x, y);
  if (x.size() >= 2) {
    double intercept, intercept_variance, covariance, variance, residual;
    gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &intercept, &found.order, &intercept_variance, &covariance,
                   &variance, &residual);
    found.half_width = half_width(x.size(), found.order, variance);
  }
  found.spacings = std::move(spacings);
  found.errors = std::move(errors);
  return found;
}

}  // namespace touchstone::vnv
