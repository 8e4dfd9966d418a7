#pragma once
/// What cases of decaying Taylor-Green vortices share, at any Reynolds number (vnv/flows/taylor_green.cpp).

#include "reference/taylor_green.hpp"
#include "vnv/flows/flow.hpp"
#include "vnv/flows/squares/square.hpp"
#include "vnv/measures/decay.hpp"
#include "vnv/measures/plots/over_time.hpp"

namespace touchstone::vnv::taylor_green {

/// Errors at `early` and the decay of energy until `end`, by methods of which those of second order have their own
/// levels.
inline constexpr double early = 0.1, end = 0.5;  // s
inline Case declared(const Flow& flow, const std::vector<Across>& of_second_order,
                     const std::map<std::string, std::vector<Claim>>& claims = {}) {
  const auto exact = flow.oracle<reference::TaylorGreen>();
  Case all{.title = flow.title(),
           .description = flow.judged.description,
           .times = {early, end},
           .monitor = kinetic_energy_every(0.01),
           .measurements = {velocity_errors(flow.velocity()), pressure_errors(flow.pressure()),
                            decay_of_energy(0, 2 * exact.decay_rate())},
           .methods = with_ladder(levels_across(square::side, {{50, early, 0, end}, {100, 0, 0, end}}),
                                  square::methods_on(scene_of<>(flow)), claims),
           .plots = {kinetic_energy_over_time(0, {"50 across"}),
                     exact_over_time(
                         "energy", [exact](double t) { return exact.energy(t); }, end)},
           .priced_as = "taylor_green"};
  for (Method& method : all.methods)
    if (method.name == "mpm_least_squares" || method.name == "sph_second_order")
      method = with_ladder(levels_across(square::side, of_second_order), method, method.claims);
  return with_plots(std::move(all), square::figures(early, l2_velocity, 50));
}

}  // namespace touchstone::vnv::taylor_green
