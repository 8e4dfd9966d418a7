#pragma once
/// The methods that run a dam break, with its gate or without, through the impact on the far wall.

#include "vnv/flows/dams/dam.hpp"
#include "vnv/methods/free_surface_methods.hpp"

#include <fmt/format.h>

namespace touchstone::vnv {

/// MPM on B-splines at 20, 40 and 80 particles over the height of the column, delta-SPH, shifted and corrected SPH,
/// whose runs take ten times as long, at 20 and 40; to 2 s, with what is claimed of some of them, by name. The suite
/// `validation` runs each at twice the resolution, until `validation` [s]; 0: not at all.
inline std::vector<Method> methods_through_impact(const Scene<Tait, Uniform>& scene, double height,
                                                  const std::map<std::string, std::vector<Claim>>& claims,
                                                  double validation = 0) {
  constexpr double end = end_of_impact;
  std::vector<Method> all = with_ladder(
      levels_across(height, {{20, end, end, end}, {40, 0, end, end}, {80, 0, 0, end}, {160, 0, 0, 0, validation}}),
      {mpm_apic(scene, sampled_every), mpm_xpic(scene, sampled_every)}, claims);
  for (const Method& method : with_ladder(
           levels_across(height, {{20, end, end, end}, {40, 0, 0, end}, {80, 0, 0, 0, validation}}),
           {sph_delta(scene, sampled_every), sph_shifted(scene, sampled_every), sph_corrected(scene, sampled_every)},
           claims))
    all.push_back(method);
  all.back().levels.back().validation = 0;  // corrected SPH makes energy there (solvers/sph/README.md)
  for (Method& method : all)
    method.tolerance = {method.family == Family::mpm ? 0.1 : 0.5,
                        "a sensor sees a few particles, whose pressures another rounding changes after the impact",
                        0.005};
  return all;
}

/// Those, and APIC with skin friction.
inline std::vector<Method> methods_with_friction(const Scene<Tait, Uniform>& scene, double height,
                                                 const SkinFriction& friction,
                                                 const std::map<std::string, std::vector<Claim>>& claims,
                                                 double validation = 0) {
  std::vector<Method> all = methods_through_impact(scene, height, claims, validation);
  Method rough = mpm_apic(with_friction(scene, friction), sampled_every);
  rough.name = "mpm_apic_friction";
  rough.description += fmt::format(" With the skin friction of the walls, c_f = {:g}, which the plane flow leaves out.",
                                   friction.coefficient);
  rough.levels = all.front().levels;
  rough.ladders = all.front().ladders;
  rough.tolerance = all.front().tolerance;
  all.push_back(rough);
  return all;
}

/// All but those of some names.
inline std::vector<Method> without(const std::vector<std::string>& names, std::vector<Method> methods) {
  std::erase_if(methods, [&](const Method& method) { return std::ranges::find(names, method.name) != names.end(); });
  return methods;
}

}  // namespace touchstone::vnv
