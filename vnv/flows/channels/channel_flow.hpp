#pragma once
/// Flows along a channel that the paper has not: its geometry and its water, six methods, each with particles across
/// the gap for its ladder.

#include "vnv/flows/channels/channel.hpp"
#include "vnv/flows/flow.hpp"
#include "vnv/methods/across.hpp"
#include "vnv/methods/methods.hpp"
#include "vnv/methods/scenes.hpp"
#include "vnv/studies/run_time.hpp"

namespace touchstone::vnv::channel {

/// Every step divides it, and it the times at which these flows are sampled [s].
inline constexpr double output_interval = 0.5e-3;

/// How stiff the fluid of a channel is made to see what that costs: from the paper's sound speed over the largest
/// speed to what is usual.
inline const std::vector<double> stiff_to_soft{1000, 300, 100, 30, 10};

Method sph_regularised(const auto& scene, double interval, double courant = 0.9) {
  return keeping_courant_number(
      courant, interval, scene, sph_regularised_solver<>,
      {.name = "sph_regularised", .family = Family::sph, .description = sph_regularised_words, .relative_cost = 2});
}

template <class SceneOfChannel>
std::vector<Method> methods_along(const SceneOfChannel& scene) {
  return {vnv::mpm_as_printed(scene, output_interval),    vnv::mpm_affine(scene, output_interval),
          vnv::mpm_least_squares(scene, output_interval), vnv::sph_as_printed(scene, output_interval),
          sph_regularised(scene, output_interval),        vnv::sph_second_order(scene, output_interval)};
}

/// The methods for a flow, of which no more is compiled into a step than it has.
inline std::vector<Method> methods_along(const Flow& flow) {
  return flow.drive.amplitude.isZero(0) ? methods_along(scene_of<Newtonian>(flow))
                                        : methods_along(scene_of<Newtonian, ForceField>(flow));
}

/// A flow between plates as a case, with so many particles across; `here` is said of it besides. Acceptance runs its
/// two coarsest levels. Three methods claim to be of second order.
inline Case flow_along(const Flow& flow, const std::vector<int>& across, const std::string& here) {
  const Truth exact = flow.along_x();
  const double end = flow.judged.times.back();
  std::vector<Across> all;
  for (const int particles : across) all.push_back({particles, all.size() < 2 ? end : 0, 0, end});
  const std::vector<Level> levels = levels_across(H, all);
  Case declared{.title = flow.title(),
                .description = flow.judged.description + " " + here,
                .times = flow.judged.times,
                .measurements = {norms_of("v_x, per particle", by_particles, exact)},
                .methods = {},
                .plots = {profiles({"profile",
                                    "Velocity profiles",
                                    "All particles of the runs that the key names.",
                                    {"y [mm]", 1e3},
                                    {"v_x [mm/s]", 1e3}},
                                   by_particles, exact, H, {levels.front().name, levels.back().name})}};
  declared = with_plots(std::move(declared), errors_of_velocity("convergence", "L2 v_x [%]", l2, end));
  const auto of_second_order = [&](const std::string& words) -> std::vector<Claim> {
    return {
        order_at_least(ladder_across, l2, 1.8, 1.5, theory(words)).of_formal_order(2).at(end).with_at_least_levels(5)};
  };
  declared.methods =
      with_ladder(levels, methods_along(flow),
                  {{"mpm", of_second_order("linear shape functions, central quadrature while particles stay in rows")},
                   {"mpm_least_squares", of_second_order("fits and differences of second order")},
                   {"sph_second_order", of_second_order("fits of second degree")}});
  for (Method& method : declared.methods)
    if (method.name == "sph_regularised")
      for (Level& level : method.levels) level.time_step = 2 * dt;
  double fastest = 0;
  for (int t = 1; t <= 20; ++t)
    for (int y = 0; y <= 40; ++y) fastest = std::max(fastest, std::abs(exact(y * H / 40, t * end / 20)));
  return with_work(std::move(declared),
                   {.error = l2, .times = {end}, .length = H, .largest_speed = fastest, .stiffness = stiff_to_soft});
}

}  // namespace touchstone::vnv::channel
