#include "vnv/flows/dams/front_comparison.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_min.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

void require_rising(std::string_view whose, const FrontHistory& front) {
  if (front.T.size() != front.L.size() || front.T.size() < 2)
    throw std::invalid_argument(fmt::format("compare_fronts: {} front has {} T and {} L, expected two or more of each",
                                            whose, front.T.size(), front.L.size()));
  for (std::size_t i = 1; i < front.T.size(); ++i)
    if (const double rise = front.T[i] - front.T[i - 1]; !(rise > 0 && std::isfinite(rise)))
      throw std::invalid_argument(
          fmt::format("compare_fronts: {} front has T = {} after {}, expected strictly increasing finite times", whose,
                      front.T[i], front.T[i - 1]));
}

void require_range(std::string_view which, const Window& window) {
  if (!(window.low <= window.high))
    throw std::invalid_argument(
        fmt::format("compare_fronts: {} from {} to {}, expected low <= high", which, window.low, window.high));
}

void require_cover(std::string_view whose, const FrontHistory& front, const Window& span, std::string_view what) {
  if (front.T.front() <= span.low && front.T.back() >= span.high) return;
  throw std::domain_error(fmt::format("compare_fronts: {} front covers T = {} to {}, expected {} to {} for the {}",
                                      whose, front.T.front(), front.T.back(), span.low, span.high, what));
}

/// The points of a front inside a window that it covers.
FrontHistory points_inside(std::string_view whose, const FrontHistory& front, const Window& window,
                           std::size_t at_least, std::string_view what) {
  require_cover(whose, front, window, what);
  const auto first = std::ranges::lower_bound(front.T, window.low) - front.T.begin();
  const auto last = std::ranges::upper_bound(front.T, window.high) - front.T.begin();
  if (last - first < static_cast<std::ptrdiff_t>(at_least))
    throw std::domain_error(
        fmt::format("compare_fronts: {} front has {} points from T = {} to {}, expected {} for the {}", whose,
                    last - first, window.low, window.high, at_least, what));
  return {{front.T.begin() + first, front.T.begin() + last}, {front.L.begin() + first, front.L.begin() + last}};
}

/// Whether every L that interpolation inside a covered span may use is a finite number.
bool known_over(const FrontHistory& front, const Window& span) {
  const auto first = std::ranges::upper_bound(front.T, span.low) - front.T.begin() - 1;
  const auto last = std::ranges::lower_bound(front.T, span.high) - front.T.begin();
  return std::all_of(front.L.begin() + first, front.L.begin() + last + 1, [](double L) { return std::isfinite(L); });
}

double rms(const FrontHistory& ours, const FrontHistory& measured, double shift) {
  double sum = 0;
  for (std::size_t j = 0; j < measured.T.size(); ++j) {
    const double miss = front_at(ours, measured.T[j] - shift) - measured.L[j];
    sum += miss * miss;
  }
  return std::sqrt(sum / static_cast<double>(measured.T.size()));
}

using Function = std::function<double(double)>;

/// Where a function is least between two places, of which it is larger than at `guess`.
double brent_minimum(const Function& function, double low, double guess, double high) {
  constexpr double tolerance = 1e-7;
  constexpr int patience = 100;
  gsl_function called{[](double x, void* f) { return (*static_cast<const Function*>(f))(x); },
                      const_cast<Function*>(&function)};
  struct Free {
    void operator()(gsl_min_fminimizer* minimiser) const { gsl_min_fminimizer_free(minimiser); }
  };
  const std::unique_ptr<gsl_min_fminimizer, Free> search(gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent));
  gsl_min_fminimizer_set(search.get(), &called, guess, low, high);
  for (int i = 0; i < patience && high - low > tolerance; ++i) {
    gsl_min_fminimizer_iterate(search.get());
    low = gsl_min_fminimizer_x_lower(search.get());
    high = gsl_min_fminimizer_x_upper(search.get());
  }
  return gsl_min_fminimizer_x_minimum(search.get());
}

/// The scan finds the valley; Brent's method refuses a place that is not below both its neighbours.
double minimum(const Function& function, const Window& range) {
  constexpr int steps = 60;
  std::vector<double> at, value;
  for (int k = 0; k <= steps; ++k) {
    at.push_back(std::lerp(range.low, range.high, static_cast<double>(k) / steps));
    value.push_back(function(at.back()));
  }
  const auto k = std::ranges::min_element(value) - value.begin();
  const bool in_a_valley = k > 0 && k < steps && value[k] < value[k - 1] && value[k] < value[k + 1];
  return in_a_valley ? brent_minimum(function, at[k - 1], at[k], at[k + 1]) : at[k];
}

}  // namespace

double front_at(const FrontHistory& front, double T) {
  const auto above = std::ranges::upper_bound(front.T, T) - front.T.begin();
  const auto k = std::clamp<std::ptrdiff_t>(above, 1, std::ssize(front.T) - 1);
  const double rise = front.L[k] - front.L[k - 1], run = front.T[k] - front.T[k - 1];
  return front.L[k - 1] + (T - front.T[k - 1]) / run * rise;  // std::lerp may lose a NaN
}

double slope_of(std::string_view whose, const FrontHistory& front, const Window& window) {
  const auto points = points_inside(whose, front, window, 2, "slope");
  double at_zero, slope, c00, c01, c11, residual;
  gsl_fit_linear(points.T.data(), 1, points.L.data(), 1, points.T.size(), &at_zero, &slope, &c00, &c01, &c11,
                 &residual);
  return slope;
}

FrontComparison compare_fronts(const FrontHistory& ours, const FrontHistory& measured, const Window& rms_window,
                               const Window& slope_window, const Window& bounds) {
  require_rising("our", ours);
  require_rising("the measured", measured);
  require_range("rms window", rms_window);
  require_range("slope window", slope_window);
  require_range("shifts", bounds);
  const auto points = points_inside("the measured", measured, rms_window, 1, "rms");
  const Window used{points.T.front() - std::max(0.0, bounds.high), points.T.back() - std::min(0.0, bounds.low)};
  require_cover("our", ours, used, "rms with all its shifts");
  const auto rms_at = [&](double shift) { return rms(ours, points, shift); };
  const bool known = known_over(ours, used) && known_over(points, {points.T.front(), points.T.back()});
  const double best = known ? minimum(rms_at, bounds) : not_known;
  return {.rms = rms_at(0),
          .best_shift = best,
          .rms_at_best_shift = known ? rms_at(best) : not_known,
          .slope = slope_of("our", ours, slope_window),
          .measured_slope = slope_of("the measured", measured, slope_window)};
}

}  // namespace touchstone::vnv
