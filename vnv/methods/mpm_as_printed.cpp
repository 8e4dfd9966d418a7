#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "solvers/mpm/walls/prescribed_velocity.hpp"
#include "solvers/mpm/walls/velocity_reset.hpp"
#include "vnv/methods/scenes.hpp"

namespace touchstone::vnv {

template <class WallTreatment, class Number, class AnyScene>
Simulation mpm_solver(const AnyScene& scene, const Level& level, double time_step) {
  return mpm::printed<WallTreatment, Number>(scene,
                                             {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
}

Method mpm_as_printed(const auto& scene, double output_interval, double courant) {
  return keeping_courant_number(
      courant, output_interval, scene, mpm_solver<>,
      {.name = "mpm",
       .family = Family::mpm,
       .description =
           "Material point method as printed by Sun et al., section 2.1: linear shape functions, lumped mass, FLIP, "
           "MUSL; four particles per cell.",
       .as_printed = true});
}

#define TOUCHSTONE_COMPILE(...)                                                                    \
  template Simulation mpm_solver<mpm::PrescribedMotion>(const __VA_ARGS__&, const Level&, double); \
  template Method mpm_as_printed(const __VA_ARGS__&, double, double);
TOUCHSTONE_SCENES(TOUCHSTONE_COMPILE)

#define TOUCHSTONE_COMPILE_VARIANTS(...)                                                                  \
  template Simulation mpm_solver<mpm::PrescribedMotion, float>(const __VA_ARGS__&, const Level&, double); \
  template Simulation mpm_solver<mpm::PrescribedVelocity>(const __VA_ARGS__&, const Level&, double);      \
  template Simulation mpm_solver<mpm::VelocityReset>(const __VA_ARGS__&, const Level&, double);
TOUCHSTONE_VISCOUS_SCENES(TOUCHSTONE_COMPILE_VARIANTS)

}  // namespace touchstone::vnv
