#pragma once
/// Water at rest under gravity, periodic along x, between a floor and a free surface.

#include "reference/hydrostatic.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/walls/free_slip.hpp"
#include "vnv/flows/flow.hpp"
#include "vnv/measures/decay.hpp"
#include "vnv/measures/norms_of.hpp"
#include "vnv/measures/profile.hpp"
#include "vnv/methods/free_surface_methods.hpp"

namespace touchstone::vnv::water_at_rest {

/// Its parameters; those that are set are those of the case.
struct Water {
  double depth = 1, width = 0.5, g = 9.81, rho0 = 1000;  // m, m, m/s², kg/m³
  double c = 40;                                         // m/s  12.8 times that of a wave on it

  constexpr Tait fluid() const { return {.density = rho0, .bulk_modulus = rho0 * c * c / Tait::gamma}; }
  reference::Hydrostatic of_depth(double h) const {
    return {.rho0 = rho0, .K = fluid().bulk_modulus, .g = g, .h = h, .gamma = Tait::gamma};
  }
  /// As deep as the water of uniform density would be of that depth.
  reference::Hydrostatic exact() const {
    double low = 0.9 * depth, high = depth;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (of_depth(middle).mass() < rho0 * depth ? low : high) = middle;
    }
    return of_depth((low + high) / 2);
  }
};

/// The height above which so much mass [kg/m²] lies in equilibrium: p = g mass.
inline double height_below(double mass, const reference::Hydrostatic& exact) {
  const double power = exact.gamma / (exact.gamma - 1), rise = std::expm1(std::log1p(exact.g * mass / exact.K) / power);
  return exact.h - power * exact.K * rise / (exact.rho0 * exact.g);
}

/// A row of a lattice over this depth [m] at the height at which it has its equilibrium column of water above it.
inline Vectors compressed(const Vectors& lattice, double depth, const reference::Hydrostatic& exact) {
  Vectors places = lattice;
  for (double& y : places.row(1).reshaped()) y = height_below(exact.rho0 * (depth - y), exact);
  return places;
}

inline Scene<Tait, Uniform> scene_with(const Water& water) {
  const reference::Hydrostatic exact = water.exact();
  return {
      .domain = {.box = {.high = {water.width, 1.2 * water.depth}}, .periodic_x = true},
      .fluid = water.fluid(),
      .filled = {.high = {water.width, water.depth}},
      .walls = {floor_at(0, free_slip())},
      .body_force = {{0, -water.g}},
      .start = {.pressure = [exact](const Vec2& x) { return exact.p(std::min(x.y(), exact.h)); },
                .places = [=](const Vectors& lattice) { return compressed(lattice, water.depth, exact); }},
  };
}

inline constexpr double depth = Water{}.depth, g = Water{}.g, c = Water{}.c;
inline constexpr double output_interval = 0.1;  // s  of which every step divides the times
inline const reference::Hydrostatic exact = Water{}.exact();
inline const Scene<Tait, Uniform> scene = scene_with({});

inline Truth pressure_of(const reference::Hydrostatic& flow) {
  return [flow](double y, double) { return y < flow.h ? flow.p(y) : 0; };
}
inline const Truth pressure_at = pressure_of(exact);
inline Measure pressures(const Level&) { return per_particle(pressure); }
inline const Quantity l2_p{"L2 p, per particle", "%", Kind::norm};

/// Kinetic over potential energy, and the highest particle [m].
inline Monitor monitored(double gravity) {
  return {
      .interval = 0.05,
      .evaluate = [gravity](const Samples& s) -> std::vector<double> {
        return {kinetic_energy(s) / (gravity * (s.mass * s.x.row(1).transpose().array()).sum()), s.x.row(1).maxCoeff()};
      },
      .quantities = {{"kinetic over potential energy"}, {"height of the highest particle", "m"}}};
}

inline constexpr double settled = 1;  // s
inline const Quantity kinetic{"maximum ratio of kinetic to potential energy after 1 s", "", Kind::error};
inline const Quantity displacement{"largest displacement of the free surface over the depth", "%", Kind::error};

/// At each time of a case once the start has died away: the largest until then.
inline Measurement spurious_motion(double of_depth) {
  return [=](const Level& level, const Run& run) {
    std::vector<Value> errors;
    for (const Samples& s : run.samples) {
      if (s.time <= settled * (1 + 1e-9)) continue;
      double largest = 0, farthest = 0;
      for (std::size_t k = 0; k < run.history.time.size() && run.history.time[k] <= s.time * (1 + 1e-9); ++k) {
        const std::vector<double>& row = run.history.values[k];
        if (run.history.time[k] >= settled) largest = std::max(largest, row[0]);
        farthest = std::max(farthest, std::abs(row[1] - run.history.values[0][1]));
      }
      errors.push_back({level.name, level.spacing, s.time, kinetic, largest});
      errors.push_back({level.name, level.spacing, s.time, displacement, 100 * farthest / of_depth});
    }
    return errors;
  };
}

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
