#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "vnv/methods/scenes.hpp"

namespace touchstone::vnv {

/// The terms of the printed method: without a laminar viscosity where the fluid has none.
template <class PressureTerm, class FluidLaw>
auto printed_terms(const FluidLaw& fluid, double h) {
  const sph::ArtificialViscosity artificial{.alpha = 0.01, .sound_speed = fluid.sound_speed(), .h = h};
  if constexpr (Viscous<FluidLaw>)
    return sph::momentum(PressureTerm{}, sph::LaminarViscosity{.nu = fluid.kinematic_viscosity(), .eta = 0.1 * h},
                         artificial);
  else
    return sph::momentum(PressureTerm{}, artificial);
}

template <class PressureTerm, class Integrator, class AnyScene>
Simulation sph_printed_solver(const AnyScene& scene, const Level& level, double time_step) {
  const double h = level.smoothing_or(1.2 * level.spacing);
  return sph::printed<sph::CubicSpline, Integrator>(
      scene, {.spacing = level.spacing, .smoothing_length = h, .time_step = time_step},
      printed_terms<PressureTerm>(scene.fluid, h));
}

Method sph_as_printed(const auto& scene, double output_interval, double courant) {
  return keeping_courant_number(
      courant, output_interval, scene, sph_printed_solver<>,
      {.name = "sph",
       .family = Family::sph,
       .description =
           "Smoothed particle hydrodynamics as printed by Sun et al., section 2.2, with the conservative pressure "
           "term and an artificial viscosity of 0.01.",
       .relative_cost = 2,
       .as_printed = true});
}

#define TOUCHSTONE_COMPILE(...)                                                                    \
  template Simulation sph_printed_solver<sph::Pressure>(const __VA_ARGS__&, const Level&, double); \
  template Method sph_as_printed(const __VA_ARGS__&, double, double);
TOUCHSTONE_SCENES(TOUCHSTONE_COMPILE)
template Simulation sph_printed_solver<sph::PressureDifference>(const Scene<Newtonian>&, const Level&, double);
template Simulation sph_printed_solver<sph::PressureDifference>(const Scene<Newtonian, Uniform>&, const Level&, double);
template Simulation sph_printed_solver<sph::PressureDifference>(const Scene<Newtonian, ForceField>&, const Level&,
                                                                double);

}  // namespace touchstone::vnv
