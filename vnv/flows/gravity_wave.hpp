#pragma once
/// A standing gravity wave of small amplitude on viscous water, periodic along x, over a floor that it slides on.

#include "reference/standing_wave.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/walls/free_slip.hpp"
#include "vnv/flows/flow.hpp"
#include "vnv/measures/damped_oscillation.hpp"
#include "vnv/methods/free_surface_methods.hpp"

#include <numbers>

namespace touchstone::vnv::gravity_wave {

/// Its parameters; those that are set are those of the case.
struct Wave {
  double L = 1, depth = 0.5, a = 0.02;  // m
  double g = 9.81, rho = 1000;          // m/s², kg/m³
  double nu = 2e-3;                     // m²/s  a third is lost in a period
  double c = 40;                        // m/s

  double k() const { return 2 * std::numbers::pi / L; }  // 1/m
  reference::StandingWave exact() const { return {.L = L, .a = a, .h = depth, .g = g, .nu = nu}; }
  Newtonian water() const { return {{.density = rho, .bulk_modulus = rho * c * c / Tait::gamma}, rho * nu}; }

  /// From rest, with particles moved as the wave moves them: up and down by the surface's height, less with the depth.
  Vectors heaped(const Vectors& lattice) const {
    Vectors places = lattice;
    for (Eigen::Index p = 0; p < lattice.cols(); ++p) {
      const double x = lattice(0, p), y = lattice(1, p), reach = a / std::sinh(k() * depth);
      places(0, p) = x - reach * std::cosh(k() * y) * std::sin(k() * x);
      places(1, p) = y + reach * std::sinh(k() * y) * std::cos(k() * x);
    }
    return places;
  }
  double pressure(const Vec2& x) const {
    const double wave = a * std::cosh(k() * x.y()) / std::cosh(k() * depth) * std::cos(k() * x.x());
    return std::max(0.0, rho * g * (depth - x.y() + wave));
  }
};

inline Scene<Newtonian, Uniform> scene_with(const Wave& wave) {
  return {
      .domain = {.box = {.high = {wave.L, 1.2 * wave.depth}}, .periodic_x = true},
      .fluid = wave.water(),
      .filled = {.high = {wave.L, wave.depth}},
      .walls = {floor_at(0, free_slip())},
      .body_force = {{0, -wave.g}},
      .start = {.pressure = [wave](const Vec2& x) { return wave.pressure(x); },
                .places = [wave](const Vectors& lattice) { return wave.heaped(lattice); }},
  };
}

inline constexpr double L = Wave{}.L;
inline constexpr double output_interval = 0.1;  // s  of which every step divides the times
inline const reference::StandingWave exact = Wave{}.exact();
inline const Scene<Newtonian, Uniform> scene = scene_with({});

/// Wave amplitude: the first moment of the particles' heights along it, over that of the exact wave at the start.
inline Monitor monitored(double length) {
  return {.interval = 0.02,
          .evaluate = [length](const Samples& s) -> std::vector<double> {
            const Scalars heights = s.x.row(1).transpose(),
                          wave = (2 * std::numbers::pi / length * s.x.row(0).transpose().array()).cos();
            return {(s.mass * heights * wave).sum()};
          },
          .quantities = {{"first moment of the particle heights", "kg"}}};
}

inline const Quantity period_error{"relative error of the period", "%", Kind::deviation},
    decay_error{"relative error of the decay rate", "%", Kind::deviation};

inline Measurement errors_of_oscillation(const reference::StandingWave& flow) {
  return [flow](const Level& level, const Run& run) -> std::vector<Value> {
    if (!run.summary.finished) return {};
    std::vector<double> heights;
    for (const std::vector<double>& row : run.history.values) heights.push_back(row[0]);
    const DampedOscillation oscillation = fit_damped_oscillation(run.history.time, heights, flow.omega());
    const double end = run.summary.end_time;
    return {{level.name, level.spacing, end, period_error, 100 * (flow.omega() / oscillation.omega - 1)},
            {level.name, level.spacing, end, decay_error, 100 * (oscillation.decay / flow.decay_rate() - 1)}};
  };
}

/// What theory says of each wave of small amplitude.
inline const Claim period_agrees = between(period_error, -1, 1, theory("the wave is linear to k² a² / 8 = 0.2 %")),
                   decay_agrees = between(decay_error, -10, 10,
                                          theory("decay of a potential flow, to first order in nu k² / omega"));

/// The methods that run it, for a scene.
inline std::vector<Method> methods_on(const Scene<Newtonian, Uniform>& seen) {
  return {mpm_as_printed(seen, output_interval, 0.4),
          mpm_affine(seen, output_interval),
          mpm_apic(seen, output_interval),
          mpm_xpic(seen, output_interval),
          sph_as_printed(seen, output_interval, 0.2),
          sph_delta(seen, output_interval)};
}

}  // namespace touchstone::vnv::gravity_wave
