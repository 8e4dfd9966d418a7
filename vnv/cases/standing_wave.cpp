/// A standing gravity wave of small amplitude: its period and its viscous decay.

#include "vnv/flows/gravity_wave.hpp"
#include "vnv/measures/plots/along_ladders.hpp"
#include "vnv/measures/plots/over_time.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::gravity_wave;

namespace {

constexpr double end = 4;  // s

const std::vector<Level> levels = levels_across(published.L, {{50, end, 0, end}, {100, 0, 0, end}, {150, 0, 0, end}});

/// From so many particles to a wave on.
std::vector<Claim> period_and_decay_agree(const std::vector<std::string>& names) {
  std::vector<Claim> all;
  for (const std::string& level : names) all.insert(all.end(), {period_agrees.on(level), decay_agrees.on(level)});
  return all;
}

/// Each up to the levels worth their cost: 150 across takes the more expensive methods three to ten minutes each, 100
/// across takes those on B-splines one or more. XPIC, the most expensive, runs in the nightly suite only; acceptance
/// tests it in the drop.
std::vector<Method> methods_up_levels(const Scene<Newtonian, Uniform>& scene) {
  Level at_night = levels[0];
  at_night.acceptance = 0;
  std::vector<Method> methods = with_ladder(levels, free_surface_methods(scene, output_interval),
                                            {{"mpm_affine", period_and_decay_agree({"100 across", "150 across"})},
                                             {"sph_delta", period_and_decay_agree({"50 across"})}});
  for (Method& method : methods)
    if (method.name == "mpm_xpic")
      method = with_ladder({at_night}, method, method.claims);
    else if (method.name == "mpm_apic")
      method = with_ladder({levels[0]}, method, method.claims);
    else if (method.relative_cost > 1)
      method = with_ladder({levels[0], levels[1]}, method, method.claims);
  return methods;
}

}  // namespace

Case vnv::the_case() {
  const Flow flow = flow_named("standing_wave");
  return {
      .title = flow.title(),
      .description = flow.judged.description + " Viscosity reduces the amplitude by a tenth in each of five periods.",
      .times = flow.judged.times,
      .monitor = flow.judged.monitor,
      .measurements = {errors_of_oscillation(flow.oracle<reference::StandingWave>())},
      .methods = methods_up_levels(scene_of<Newtonian, Uniform>(flow)),
      .plots = {over_time("swing", "First moment of the particle heights",
                          "Mass times height times the cosine of the wave, summed over all particles.",
                          {"moment [kg m / m]"}, 0, {"100 across"})},
      .priced_as = "elliptic_drop"};
}
