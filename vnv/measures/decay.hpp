#pragma once
/// Kinetic energy, and how fast what is monitored decays.

#include "vnv/case.hpp"

#include <gsl/gsl_fit.h>

#include <cmath>
#include <string>
#include <vector>

namespace touchstone::vnv {

/// Kinetic energy per depth [J/m].
inline double kinetic_energy(const Samples& samples) {
  return (samples.mass * samples.v.colwise().squaredNorm().transpose().array()).sum() / 2;
}

/// What a run is monitored for every so often [s]: its kinetic energy, in the first column.
inline Monitor kinetic_energy_every(double interval) {
  return {.interval = interval,
          .evaluate = [](const Samples& s) { return std::vector{kinetic_energy(s)}; },
          .quantities = {{"kinetic energy", "J/m"}}};
}

/// Angular momentum per depth about a place [kg m/s].
inline double angular_momentum(const Samples& samples, const Vec2& about = Vec2::Zero()) {
  double sum = 0;
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    const Vec2 arm = samples.x.col(p) - about;
    sum += samples.mass[p] * (arm.x() * samples.v(1, p) - arm.y() * samples.v(0, p));
  }
  return sum;
}

/// Kinetic energy at each time of a run, over `unit` [J/m], as that quantity.
inline Measurement kinetic_energy_over(double unit, const Quantity& quantity) {
  return [=](const Level& level, const Run& run) {
    std::vector<Value> found;
    for (const Samples& s : run.samples)
      found.push_back({level.name, level.spacing, s.time, quantity, kinetic_energy(s) / unit});
    return found;
  };
}

/// The rate [1/s] of the exponential through positive values over time [s]: the slope of the least-squares line through
/// their logs, its sign turned. Not a number for fewer than two values, or for one that is not positive.
inline double rate_of_decay(const std::vector<double>& times, const std::vector<double>& values) {
  if (values.size() < 2) return not_a_number;
  std::vector<double> logs;
  for (const double value : values) logs.push_back(value > 0 ? std::log(value) : not_a_number);
  double at_zero, slope, c00, c01, c11, squares;
  gsl_fit_linear(times.data(), 1, logs.data(), 1, logs.size(), &at_zero, &slope, &c00, &c01, &c11, &squares);
  return -slope;
}

/// "relative error of the kinetic-energy decay rate [%]", of the kinetic energy that was monitored in `column`.
inline const Quantity decay_error{"relative error of the kinetic-energy decay rate", "%", Kind::deviation};
inline Measurement decay_of_energy(std::size_t column, double exact_rate) {
  return [=](const Level& level, const Run& run) -> std::vector<Value> {
    if (!run.summary.finished) return {};
    std::vector<double> energy;
    for (const std::vector<double>& row : run.history.values) energy.push_back(row[column]);
    const double rate = rate_of_decay(run.history.time, energy);
    return {{level.name, level.spacing, run.summary.end_time, decay_error, 100 * (rate / exact_rate - 1)}};
  };
}

}  // namespace touchstone::vnv
