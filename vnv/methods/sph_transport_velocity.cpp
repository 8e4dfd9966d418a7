#include "solvers/integrators/adams_bashforth.hpp"
#include "solvers/integrators/kick_drift_kick.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "solvers/sph/transport_velocity/transport_velocity.hpp"
#include "vnv/methods/scenes.hpp"

namespace touchstone::vnv {

Simulation sph_transport_velocity_solver(const auto& scene, const Level& level, double time_step) {
  return sph::transport_velocity<sph::QuinticSpline>(
      scene, {.spacing = level.spacing, .smoothing_length = level.smoothing_or(level.spacing), .time_step = time_step},
      sph::momentum(sph::Pressure{}, sph::MorrisViscosity{.mu = scene.fluid.viscosity}));
}

template <class Integrator, class Real, class AnyScene>
Simulation sph_regularised_solver(const AnyScene& scene, const Level& level, double time_step) {
  return sph::transport_velocity<sph::QuinticSpline, Integrator, Real, sph::Without<sph::DriftMomentum>>(
      scene, {.spacing = level.spacing, .smoothing_length = level.smoothing_or(level.spacing), .time_step = time_step},
      sph::momentum(sph::PressureDifference{}, sph::MorrisViscosity{.mu = scene.fluid.viscosity}));
}

Method sph_transport_velocity(const auto& scene, double output_interval, double courant) {
  return keeping_courant_number(
      courant, output_interval, scene, sph_transport_velocity_solver,
      {.name = "sph_transport_velocity",
       .family = Family::sph,
       .description =
           "Smoothed particle hydrodynamics with a transport velocity (Adami, Hu & Adams 2013), quintic spline with h "
           "= 1 spacing, density by continuity, conservative pressure.",
       .relative_cost = 2});
}

#define TOUCHSTONE_COMPILE(...)                                                                               \
  template Simulation sph_transport_velocity_solver(const __VA_ARGS__&, const Level&, double);                \
  template Method sph_transport_velocity(const __VA_ARGS__&, double, double);                                 \
  template Simulation sph_regularised_solver<KickDriftKick>(const __VA_ARGS__&, const Level&, double);        \
  template Simulation sph_regularised_solver<KickDriftKick, float>(const __VA_ARGS__&, const Level&, double); \
  template Simulation sph_regularised_solver<AdamsBashforth>(const __VA_ARGS__&, const Level&, double);
TOUCHSTONE_VISCOUS_SCENES(TOUCHSTONE_COMPILE)

}  // namespace touchstone::vnv
