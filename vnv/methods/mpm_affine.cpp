#include "solvers/mpm/lanes/in_lanes.hpp"
#include "vnv/methods/scenes.hpp"

namespace touchstone::vnv {

Simulation mpm_affine_solver(const auto& scene, const Level& level, double time_step) {
  return mpm::in_lanes<mpm::QuadraticBSpline, mpm::MlsApic>(
      scene, {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
}

Method mpm_affine(const auto& scene, double output_interval, double courant) {
  return keeping_courant_number(
      courant, output_interval, scene, mpm_affine_solver,
      {.name = "mpm_affine",
       .family = Family::mpm,
       .description =
           "Material point method with quadratic B-splines and affine particle velocities (APIC), four particles in a "
           "cell. Each step adds dissipation, so that larger steps are more accurate."});
}

#define TOUCHSTONE_COMPILE(...)                                                    \
  template Simulation mpm_affine_solver(const __VA_ARGS__&, const Level&, double); \
  template Method mpm_affine(const __VA_ARGS__&, double, double);
TOUCHSTONE_SCENES(TOUCHSTONE_COMPILE)

}  // namespace touchstone::vnv
