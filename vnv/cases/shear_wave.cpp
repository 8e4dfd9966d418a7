/// A decaying shear wave: the viscous term alone, in a fluid whose rows of particles slip past each other.

#include "reference/shear_wave.hpp"
#include "vnv/flows/flow.hpp"
#include "vnv/flows/squares/square.hpp"
#include "vnv/measures/decay.hpp"
#include "vnv/measures/plots/over_time.hpp"
#include "vnv/studies/run_time.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::square;

namespace {

constexpr double early = 0.1, end = 1;  // s

const std::vector<Level> levels = levels_across(
    side, {{32, early, 0, end}, {44, early, 0, end}, {64, 0, 0, end}, {88, 0, 0, early}, {128, 0, 0, early}});
/// Where errors of fourth order no longer hide those of second.
const std::vector<Level> finer_levels = levels_across(
    side, {{64, early, 0, end}, {88, early, 0, early}, {128, 0, 0, early}, {176, 0, 0, early}, {256, 0, 0, early}});

Claim of_second_order(const std::string& words) {
  return order_at_least(ladder_across, l2_velocity, 1.8, 1.5, theory(words))
      .of_formal_order(2)
      .at(early)
      .with_at_least_levels(5);
}

}  // namespace

Case vnv::the_case() {
  const Flow flow = flow_named("shear_wave");
  const auto scene = scene_of<>(flow);
  const auto exact = flow.oracle<reference::ShearWave>();
  const auto energy = [exact, rho = flow.fluid.density](double t) {
    const double v = exact(side / 4, t);
    return rho * side * side * v * v / 4;
  };
  Case declared = with_plots(
      {.title = flow.title(),
       .description = flow.judged.description +
                      " Reynolds number 100, Mach number 0.1. Pressure and density stay uniform.",
       .times = flow.judged.times,
       .monitor = kinetic_energy_every(0.02),
       .measurements = {velocity_errors(flow.velocity()), decay_of_energy(0, 2 * exact.decay_rate())},
       .methods = {with_ladder(levels, mpm_as_printed(scene, output_interval)),
                   with_ladder(levels, mpm_gimp(scene, output_interval),
                               {of_second_order("linear shape functions, averaged over particles that stay in rows")}),
                   with_ladder(levels, mpm_affine(scene, output_interval)),
                   with_ladder(finer_levels, mpm_least_squares(scene, output_interval),
                               {of_second_order("fits and differences")}),
                   with_ladder(levels, sph_as_printed(scene, output_interval)),
                   with_ladder(levels, sph_transport_velocity(scene, output_interval)),
                   with_ladder(finer_levels, sph_second_order(scene, output_interval),
                               {of_second_order("fits of second degree")})},
       .plots = {kinetic_energy_over_time(0, {"32 across"}), exact_over_time("energy", energy, end)}},
      figures(early, l2_velocity, 10));
  return with_work(std::move(declared),
                   {.error = l2_velocity,
                    .times = {end},
                    .length = side,
                    .largest_speed = flow["U"],
                    .stiffness = {10, 5, 3}});
}
