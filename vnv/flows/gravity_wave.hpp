#pragma once
/// What cases of a standing gravity wave share (vnv/flows/standing_wave.cpp).

#include "reference/standing_wave.hpp"
#include "vnv/flows/by_all_methods.hpp"
#include "vnv/measures/damped_oscillation.hpp"

namespace touchstone::vnv::gravity_wave {

/// Where nothing else is set; a third of it is lost in a period.
inline constexpr reference::StandingWave published{.L = 1, .a = 0.02, .h = 0.5, .g = 9.81, .nu = 2e-3};

/// Particles moved as the wave moves them: up and down by the surface's height, less with the depth.
inline Vectors heaped(const reference::StandingWave& wave, const Vectors& lattice) {
  const double k = wave.k(), reach = wave.a / std::sinh(k * wave.h);
  Vectors places = lattice;
  for (Eigen::Index p = 0; p < lattice.cols(); ++p) {
    const double x = lattice(0, p), y = lattice(1, p);
    places(0, p) = x - reach * std::cosh(k * y) * std::sin(k * x);
    places(1, p) = y + reach * std::sinh(k * y) * std::cos(k * x);
  }
  return places;
}

inline constexpr double output_interval = 0.1;  // s  of which every step divides the times

/// Fitted to the first moments of the particles' heights, which are monitored.
inline DampedOscillation oscillation_of(const Run& run, const reference::StandingWave& wave) {
  std::vector<double> heights;
  for (const std::vector<double>& row : run.history.values) heights.push_back(row[0]);
  return fit_damped_oscillation(run.history.time, heights, wave.omega());
}

inline const Quantity period_error{"relative error of the period", "%", Kind::deviation},
    decay_error{"relative error of the decay rate", "%", Kind::deviation};

inline Measurement errors_of_oscillation(const reference::StandingWave& wave) {
  return [wave](const Level& level, const Run& run) -> std::vector<Value> {
    if (!run.summary.finished) return {};
    const DampedOscillation found = oscillation_of(run, wave);
    const double end = run.summary.end_time;
    return {{level.name, level.spacing, end, period_error, 100 * (wave.omega() / found.omega - 1)},
            {level.name, level.spacing, end, decay_error, 100 * (found.decay / wave.decay_rate() - 1)}};
  };
}

/// What theory says of each wave of small amplitude.
inline const Claim period_agrees = between(period_error, -1, 1, theory("the wave is linear to k² a² / 8 = 0.2 %")),
                   decay_agrees = between(decay_error, -10, 10,
                                          theory("decay of a potential flow, to first order in nu k² / omega"));

}  // namespace touchstone::vnv::gravity_wave
