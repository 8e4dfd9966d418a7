#pragma once
/// A standing gravity wave of small amplitude on viscous water, periodic along x, over a floor that it slides on.

#include "reference/standing_wave.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/walls/free_slip.hpp"
#include "vnv/methods/free_surface_methods.hpp"

#include <numbers>

namespace touchstone::vnv::gravity_wave {

inline constexpr double L = 1, depth = 0.5, a = 0.02, g = 9.81, rho = 1000;  // m, m, m, m/s², kg/m³
inline constexpr double nu = 2e-3;                                           // m²/s  a third is lost in a period
inline constexpr double c = 40;                                              // m/s
inline constexpr double output_interval = 0.1;                               // s  of which every step divides the times
inline const reference::StandingWave exact{.L = L, .a = a, .h = depth, .g = g, .nu = nu};
inline constexpr Newtonian water{{.density = rho, .bulk_modulus = rho * c * c / 7}, rho* nu};

/// From rest, with particles moved as the wave moves them: up and down by the surface's height, less with the depth.
inline Vectors heaped(const Vectors& lattice) {
  constexpr double k = 2 * std::numbers::pi / L;
  Vectors places = lattice;
  for (Eigen::Index p = 0; p < lattice.cols(); ++p) {
    const double x = lattice(0, p), y = lattice(1, p), reach = a / std::sinh(k * depth);
    places(0, p) = x - reach * std::cosh(k * y) * std::sin(k * x);
    places(1, p) = y + reach * std::sinh(k * y) * std::cos(k * x);
  }
  return places;
}

inline double pressure(const Vec2& x) {
  constexpr double k = 2 * std::numbers::pi / L;
  const double wave = a * std::cosh(k * x.y()) / std::cosh(k * depth) * std::cos(k * x.x());
  return std::max(0.0, rho * g * (depth - x.y() + wave));
}

inline const Scene<Newtonian, Uniform> scene{
    .domain = {.box = {.high = {L, 1.2 * depth}}, .periodic_x = true},
    .fluid = water,
    .filled = {.high = {L, depth}},
    .walls = {floor_at(0, free_slip())},
    .body_force = {{0, -g}},
    .start = {.pressure = pressure, .places = heaped},
};

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
