#include "solvers/mpm/lanes/in_lanes.hpp"
#include "vnv/methods/scenes.hpp"

namespace touchstone::vnv {

Simulation mpm_gimp_solver(const auto& scene, const Level& level, double time_step) {
  return mpm::in_lanes<mpm::Gimp, mpm::Flip>(scene,
                                             {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
}

Method mpm_gimp(const auto& scene, double output_interval, double courant) {
  return keeping_courant_number(
      courant, output_interval, scene, mpm_gimp_solver,
      {.name = "mpm_gimp",
       .family = Family::mpm,
       .description =
           "Generalised interpolation material point method with particles that stay squares (uniform GIMP, Bardenhagen & "
           "Kober 2004), FLIP, MUSL; four particles per cell.",
       .relative_cost = 2});
}

#define TOUCHSTONE_COMPILE(...) template Method mpm_gimp(const __VA_ARGS__&, double, double);
TOUCHSTONE_COMPILE(Scene<Newtonian>)
TOUCHSTONE_COMPILE(Scene<Newtonian, ForceField>)

}  // namespace touchstone::vnv
