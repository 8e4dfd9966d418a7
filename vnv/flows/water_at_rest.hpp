#pragma once
/// What cases of water at rest share (vnv/flows/hydrostatic.cpp).

#include "reference/hydrostatic.hpp"
#include "vnv/flows/by_all_methods.hpp"
#include "vnv/measures/norms_of.hpp"
#include "vnv/measures/profile.hpp"

namespace touchstone::vnv::water_at_rest {

inline constexpr double depth = 1, g = 9.81, c = 40;  // m, m/s², m/s  where nothing else is set
inline constexpr double output_interval = 0.1;        // s  of which every step divides the times
inline constexpr double settled = 1;                  // s

inline const Quantity l2_p{"L2 p, per particle", "%", Kind::norm},
    kinetic{"maximum ratio of kinetic to potential energy after 1 s", "", Kind::error},
    displacement{"largest displacement of the free surface over the depth", "%", Kind::error};

inline Truth pressure_of(const reference::Hydrostatic& water) {
  return [water](double y, double) { return y < water.h ? water.p(y) : 0; };
}
inline Measure pressures(const Level&) { return per_particle(pressure); }

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

/// The methods that run it.
inline std::vector<Method> methods_on(const Scene<Tait, Uniform>& scene) {
  return free_surface_methods(scene, output_interval, {.ratio = 1.5, .alpha = 0.1, .courant = 1});
}

}  // namespace touchstone::vnv::water_at_rest
