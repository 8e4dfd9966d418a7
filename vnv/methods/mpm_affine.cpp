#include "vnv/methods/methods.hpp"

#include "solvers/mpm/affine/affine.hpp"
#include "vnv/methods/scenes.hpp"
#include "vnv/methods/setups.hpp"

#include <fmt/format.h>

namespace touchstone::vnv {

template <class AnyScene>
Simulation mpm_affine_solver(const AnyScene& scene, const Level& level, double time_step) {
  return mpm::affine(scene, {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
}

template <class AnyScene>
Method mpm_affine(const AnyScene& scene, double output_interval, double courant) {
  return simulating(
      {.name = "mpm_affine",
       .family = Family::mpm,
       .description = fmt::format(
           "Material point method with quadratic B-splines and affine particle velocities (APIC), four particles in a "
           "cell. Acoustic Courant number {:g}, by the cell; each step adds dissipation, so that larger steps are more accurate.",
           courant),
       .tolerance = stretched},
      [=](const Level& level, double time_step) { return mpm_affine_solver(scene, level, time_step); },
      by_cells(scene, courant, output_interval));
}

#define TOUCHSTONE_COMPILE(...)                                                    \
  template Simulation mpm_affine_solver(const __VA_ARGS__&, const Level&, double); \
  template Method mpm_affine(const __VA_ARGS__&, double, double);
TOUCHSTONE_VISCOUS_SCENES(TOUCHSTONE_COMPILE)
TOUCHSTONE_INVISCID_SCENES(TOUCHSTONE_COMPILE)

}  // namespace touchstone::vnv
