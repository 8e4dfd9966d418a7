/// The largest stable time step of each method in water at rest under gravity: with a free surface, a bottom wall and
/// gravity.

#include "vnv/flows/water_at_rest.hpp"
#include "vnv/stability/critical_step.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::water_at_rest;

namespace {

/// Water at rest never moves at a twentieth of the speed of a wave on it; 2000 steps are some 2 s.
const double speed_limit = 0.05 * std::sqrt(g * depth);

Method limits_of(Method method) {
  const auto solver = method.solver;
  const auto own_step = method.time_step;
  method.run = [=, family = method.family](const Level& level, const Schedule&) {
    const double length = family == Family::mpm ? level.cell : level.spacing, a_length = length / c;
    Run run =
        search_critical_step([&](double time_step) { return solver(level, time_step); },
                             {.low = 0.05 * a_length, .high = 8 * a_length, .speed_limit = speed_limit}, length, c);
    run.add(step_chosen, own_step(level) / run.summary.time_step);
    return run;
  };
  method.levels = {{.name = "20 across", .spacing = depth / 20, .cell = depth / 10, .acceptance = 1, .nightly = 1},
                   {.name = "40 across", .spacing = depth / 40, .cell = depth / 20, .nightly = 1}};
  method.tolerance = moved_limit;
  method.claims = {chosen_is_stable};
  return method;
}

}  // namespace

Case vnv::the_case() {
  std::vector<Method> methods = methods_on(scene_of<Tait, Uniform>(flow_named("hydrostatic")));
  std::ranges::transform(methods, methods.begin(), limits_of);
  return {
      .title = "Largest stable time step in water at rest",
      .description =
          "Water 1 m deep under gravity, in the equilibrium of Tait's law, between a bottom wall and a free surface. "
          "The largest step is found by bisection, 2000 steps a trial; a trial is unstable when a particle reaches a "
          "twentieth of the gravity wave speed. What a method loses here relative to a periodic lattice is due to the "
          "free surface, where grid nodes are nearly empty and kernels are truncated.",
      .times = {1},
      .measurements = {},
      .methods = methods,
      .plots = {limits_table("Largest stable step in water at rest", words_of_limits, "particles",
                             {{"stable [us]", stable_end},
                              {"unstable [us]", unstable_end},
                              {"stable, c dt / length", over_courant},
                              {"chosen / stable", step_chosen},
                              {"growth", growth_beyond}})},
      .label = "stability",
  };
}
