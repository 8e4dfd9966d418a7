#pragma once
/// Water at rest under gravity, periodic along x, between a floor and a free surface.

#include "reference/hydrostatic.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/walls/free_slip.hpp"
#include "vnv/measures/per_particle.hpp"
#include "vnv/methods/free_surface_methods.hpp"

namespace touchstone::vnv::water_at_rest {

inline constexpr double depth = 1, width = 0.5, g = 9.81, rho0 = 1000;  // m, m, m/s², kg/m³
inline constexpr double c = 40;                                         // m/s  12.8 times that of a wave on it
inline constexpr double output_interval = 0.1;                          // s  of which every step divides the times
inline constexpr Tait water{.density = rho0, .bulk_modulus = rho0 * c * c / 7};

/// As deep as water of uniform density would be 1 m deep.
inline reference::Hydrostatic of_depth(double h) {
  return {.rho0 = rho0, .K = water.bulk_modulus, .g = g, .h = h, .gamma = water.gamma};
}
inline double compressed_depth() {
  double low = 0.9 * depth, high = depth;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (of_depth(middle).mass() < rho0 * depth ? low : high) = middle;
  }
  return (low + high) / 2;
}
inline const reference::Hydrostatic exact = of_depth(compressed_depth());

/// The height above which so much mass [kg/m²] lies in equilibrium: p = g mass.
inline double height_below(double mass) {
  const double power = exact.gamma / (exact.gamma - 1), rise = std::expm1(std::log1p(g * mass / exact.K) / power);
  return exact.h - power * exact.K * rise / (rho0 * g);
}
inline Vectors compressed(const Vectors& lattice) {
  Vectors places = lattice;
  for (double& y : places.row(1).reshaped()) y = height_below(rho0 * (depth - y));
  return places;
}

inline const Scene<Tait, Uniform> scene{
    .domain = {.box = {.high = {width, 1.2 * depth}}, .periodic_x = true},
    .fluid = water,
    .filled = {.high = {width, depth}},
    .walls = {floor_at(0, free_slip())},
    .body_force = {{0, -g}},
    .start = {.pressure = [](const Vec2& x) { return exact.p(std::min(x.y(), exact.h)); }, .places = compressed},
};

inline double pressure_at(double y, double /*t*/) { return y < exact.h ? exact.p(y) : 0; }
inline Measure pressures(const Level&) { return per_particle(pressure); }
inline const Quantity l2_p{"L2 p, per particle", "%", Kind::norm};

// The methods that run it, for a scene.
inline Method printed(const Scene<Tait, Uniform>& seen) { return mpm_as_printed(seen, output_interval, 0.4); }
inline Method affine(const Scene<Tait, Uniform>& seen) { return mpm_affine(seen, output_interval); }
inline Method apic(const Scene<Tait, Uniform>& seen) { return mpm_apic(seen, output_interval); }
inline Method xpic(const Scene<Tait, Uniform>& seen) { return mpm_xpic(seen, output_interval); }
inline Method printed_sph(const Scene<Tait, Uniform>& seen) { return sph_as_printed(seen, output_interval, 0.2); }
inline Method delta(const Scene<Tait, Uniform>& seen) {
  return sph_delta(seen, output_interval, {.ratio = 1.5, .alpha = 0.1, .courant = 1});
}

}  // namespace touchstone::vnv::water_at_rest
