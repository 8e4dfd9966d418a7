#pragma once
/// Ladders of flows that one length measures: so many particles across a side or a gap.

#include "vnv/case.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::vnv {

inline const std::string ladder_across = "particles across";

/// So many particles across, and how far each suite runs them [s].
struct Across {
  int particles;
  double acceptance, report, nightly, validation = 0;
};

/// In MPM with four particles to a cell.
inline std::vector<Level> levels_across(double length, const std::vector<Across>& all) {
  std::vector<Level> levels;
  for (const Across& a : all)
    levels.push_back({.name = std::to_string(a.particles) + " across",
                      .spacing = length / a.particles,
                      .cell = 2 * length / a.particles,
                      .acceptance = a.acceptance,
                      .report = a.report,
                      .nightly = a.nightly,
                      .validation = a.validation});
  return levels;
}

/// A method with levels that are one ladder, and what is claimed of it.
inline Method with_ladder(const std::vector<Level>& levels, Method method, std::vector<Claim> claims = {}) {
  Ladder all{ladder_across, {}};
  for (const Level& level : levels) all.levels.push_back(level.name);
  method.levels = levels;
  method.ladders = {all};
  method.claims = std::move(claims);
  return method;
}

/// The same of several, with what is claimed of some of them, by name.
inline std::vector<Method> with_ladder(const std::vector<Level>& levels, std::vector<Method> methods,
                                       const std::map<std::string, std::vector<Claim>>& claims) {
  for (Method& method : methods) {
    const auto of_it = claims.find(method.name);
    method = with_ladder(levels, std::move(method), of_it == claims.end() ? std::vector<Claim>{} : of_it->second);
  }
  return methods;
}

/// The longest step [s] that an explicit method takes with such a length [m], its cell or spacing, so that it stays
/// below all its limits: its acoustic Courant number c dt / length is `courant`, which is the method's own safety below
/// the limit that `critical_step_lattice` measures; viscosity and body force keep to length² / (8 nu) and sqrt(length /
/// force) / 4 (Morris, Fox & Zhu, J. Comput. Phys. 136 (1997), (20) and (21)), a third of what `stability_map` measures
/// or less.
template <class AnyScene>
double longest_step(const AnyScene& scene, double courant, double length) {
  double longest = courant * length / scene.fluid.sound_speed();
  if constexpr (requires { scene.fluid.kinematic_viscosity(); }) {
    const double nu = scene.fluid.kinematic_viscosity();
    if (nu > 0) longest = std::min(longest, 0.125 * length * length / nu);
  }
  if constexpr (requires { scene.body_force.per_mass; }) {
    const double force = scene.body_force.per_mass.norm();
    if (force > 0) longest = std::min(longest, 0.25 * std::sqrt(length / force));
  }
  return longest;
}

/// That step, or a little less: there is a whole number of them in `output_interval` [s].
template <class AnyScene>
double step_for(const AnyScene& scene, double courant, double length, double output_interval) {
  return output_interval / std::ceil(output_interval / longest_step(scene, courant, length) * (1 - 1e-9));
}

}  // namespace touchstone::vnv
