#pragma once
/// What is told of an impact of water on a sensor: arrival, first peak, how it rises and decays, impulse, plateau.

#include "vnv/judge/series.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace touchstone::vnv {

/// How an impact is looked for in a pressure over time, in Pa and s or by any one unit each.
struct ImpactSearch {
  double threshold;                 // Pa  above which it has begun
  double peak_within;               // s   from then on; the largest sample is the first peak
  double plateau_from, plateau_to;  // s   after arrival
  double arrival_fraction = 0.1;    // -   of the first peak, at which it arrives
  double impulse_over = 0.1;        // s   after arrival
};

/// Each is not a number where the series does not reach, all are where there is no impact, or none whose peak is over
/// within the time given to it.
struct Impact {
  double arrival = not_a_number;       // s     when the pressure first rises above that fraction of the first peak
  double peak = not_a_number;          // Pa
  double peak_time = not_a_number;     // s
  double rise = not_a_number;          // s     from half the peak to it, the last time before
  double decay = not_a_number;         // s     from it to half of it, the first time after
  double peak_impulse = not_a_number;  // Pa s  over rise and decay, as by Lobovský et al. (2014)
  double impulse = not_a_number;       // Pa s  over a fixed time after arrival
  double plateau = not_a_number;       // Pa    mean over a window after arrival
};

namespace impacts {

/// The first time at which the series is above a level, between samples; not a number if it never is.
inline double first_above(const Series& series, double level) {
  const auto above = std::ranges::find_if(series.value, [=](double value) { return value > level; });
  if (above == series.value.end()) return not_a_number;
  const auto k = static_cast<std::size_t>(above - series.value.begin());
  if (k == 0) return series.time[0];
  return std::lerp(series.time[k - 1], series.time[k],
                   (level - series.value[k - 1]) / (series.value[k] - series.value[k - 1]));
}

/// The largest sample between two times, both included; -infinity without one.
inline double largest(const Series& series, double from, double to) {
  double most = -INFINITY;
  for (std::size_t k = 0; k < series.time.size(); ++k)
    if (series.time[k] >= from && series.time[k] <= to) most = std::max(most, series.value[k]);
  return most;
}

/// The time at which the series is at `level`, on the way from sample `k`, which is above it, in steps of 1 or -1.
inline double left_at(const Series& series, std::size_t k, int step, double level) {
  const std::size_t end = step > 0 ? series.time.size() - 1 : 0;
  for (; k != end; k += static_cast<std::size_t>(step)) {
    const std::size_t next = k + static_cast<std::size_t>(step);
    if (series.value[next] <= level)
      return std::lerp(series.time[k], series.time[next],
                       (level - series.value[k]) / (series.value[next] - series.value[k]));
  }
  return not_a_number;
}

}  // namespace impacts

/// Of a pressure [Pa] over time [s]. All depends on how often it is sampled, the peak most of all. All are not a number
/// if a sample is none. Throws as `require_series`, and std::invalid_argument for a search whose lengths, fraction or
/// threshold are not positive, or whose plateau ends before it begins.
inline Impact impact_of(const Series& pressure, const ImpactSearch& search) {
  require_series("impact", pressure);
  if (!(search.threshold > 0 && search.peak_within > 0 && search.arrival_fraction > 0 && search.arrival_fraction < 1 &&
        search.impulse_over > 0 && search.plateau_from < search.plateau_to))
    throw std::invalid_argument(fmt::format(
        "impact: threshold {} Pa, peak within {} s, arrival at {}, impulse over {} s, plateau from {} to {} s, expected "
        "positive ones, a fraction below 1 and a plateau that ends after it begins",
        search.threshold, search.peak_within, search.arrival_fraction, search.impulse_over, search.plateau_from,
        search.plateau_to));
  const bool known = std::ranges::all_of(pressure.value, [](double value) { return std::isfinite(value); });
  const double begun = known ? impacts::first_above(pressure, search.threshold) : not_a_number;
  if (std::isnan(begun)) return {};
  const auto first = std::ranges::lower_bound(pressure.time, begun) - pressure.time.begin();
  const auto last = std::ranges::upper_bound(pressure.time, begun + search.peak_within) - pressure.time.begin();
  if (first == last) return {};
  const auto highest = std::max_element(pressure.value.begin() + first, pressure.value.begin() + last);
  if (highest + 1 == pressure.value.begin() + last) return {};
  const auto k = static_cast<std::size_t>(highest - pressure.value.begin());

  Impact found{.peak = *highest, .peak_time = pressure.time[k]};
  found.arrival = impacts::first_above(pressure, search.arrival_fraction * found.peak);
  const double before = impacts::left_at(pressure, k, -1, found.peak / 2),
               after = impacts::left_at(pressure, k, 1, found.peak / 2);
  found.rise = found.peak_time - before;
  found.decay = after - found.peak_time;
  if (before < after) found.peak_impulse = time_integral(pressure, before, after);
  found.impulse = time_integral(pressure, found.arrival, found.arrival + search.impulse_over);
  found.plateau = time_mean(pressure, found.arrival + search.plateau_from, found.arrival + search.plateau_to);
  return found;
}

}  // namespace touchstone::vnv
