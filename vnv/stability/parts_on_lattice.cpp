#include "vnv/stability/parts_on_lattice.hpp"

#include "solvers/integrators/adams_bashforth.hpp"
#include "solvers/integrators/kick_drift_kick.hpp"
#include "solvers/integrators/predictor_corrector.hpp"
#include "solvers/mpm/lanes/in_lanes.hpp"
#include "solvers/sph/free_surface/diffusion/antuono.hpp"
#include "solvers/sph/free_surface/free_surface.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/terms/monaghan_cleary_viscosity.hpp"
#include "solvers/sph/terms/pressure_sum.hpp"

#include <fmt/format.h>

namespace touchstone::vnv {
namespace {

template <class Shape, class Transfer, class Density = mpm::CarriedDensity>
LatticeMethod mpm_with(const std::string& name, const std::string& part) {
  const OnLattice method = solved_by(
      {.name = name,
       .family = Family::mpm,
       .description =
           "Material point method with linear shape functions, FLIP, MUSL and densities stored on particles, except for " +
           part + ".",
       .relative_cost = 2},
      0.4, [](const Scene<Newtonian>& scene, const Level& level, double time_step) {
        return mpm::in_lanes<Shape, Transfer, Density>(
            scene, {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
      });
  return {.on = method, .at_night_only = true};
}

/// `ratio` is that of h to the spacing.
template <class Kernel, class Integrator, class MakeParts>
LatticeMethod sph_with(const std::string& name, const std::string& part, double ratio, MakeParts parts) {
  const OnLattice method =
      solved_by({.name = name,
                 .family = Family::sph,
                 .description = fmt::format("delta-SPH with sums of pressures, Wendland's C2 kernel and "
                                            "kick-drift-kick, except for {}; h = {:g} spacings.",
                                            part, ratio),
                 .relative_cost = 2},
                0.3, [=](const Scene<Newtonian>& scene, const Level& level, double time_step) {
                  const double h = level.smoothing_or(ratio * level.spacing);
                  return sph::free_surface<Kernel, Integrator>(
                      scene, {.spacing = level.spacing, .smoothing_length = h, .time_step = time_step},
                      sph::momentum(sph::MonaghanClearyViscosity{.mu = scene.fluid.viscosity}), parts(scene.fluid, h));
                });
  return {.on = method, .at_night_only = true};
}

constexpr auto usual_parts = [](const Newtonian& fluid, double h) {
  return sph::Parts(sph::PressureSum{}, sph::Antuono{.delta = 0.1, .sound_speed = fluid.sound_speed(), .h = h});
};
template <class Kernel>
LatticeMethod sph_with_kernel(const std::string& name, const std::string& part, double ratio) {
  return sph_with<Kernel, KickDriftKick>(name, part, ratio, usual_parts);
}
template <class Integrator>
LatticeMethod sph_moved_by(const std::string& name, const std::string& part) {
  return sph_with<sph::WendlandC2, Integrator>(name, part, 2, usual_parts);
}

}  // namespace

std::vector<LatticeMethod> parts_on_lattice() {
  using Hat = mpm::LinearHat;
  return {
      mpm_with<mpm::Gimp, mpm::Flip>("mpm_gimp", "generalised interpolation (GIMP) in place of linear shape functions"),
      mpm_with<mpm::BSpline<2>, mpm::Flip>("mpm_quadratic", "quadratic B-splines in place of linear shape functions"),
      mpm_with<mpm::BSpline<3>, mpm::Flip>("mpm_cubic", "cubic B-splines in place of linear shape functions"),
      mpm_with<Hat, mpm::Xpic<2>>("mpm_xpic_2", "XPIC(2)"),
      mpm_with<Hat, mpm::Apic>("mpm_apic_hats", "affine particle velocities (APIC)"),
      mpm_with<Hat, mpm::Flip, mpm::AffineDensity>("mpm_affine_density", "densities smoothed over nodes"),
      sph_with_kernel<sph::CubicSpline>("sph_cubic", "the cubic spline", 1.5),
      sph_with_kernel<sph::QuinticSpline>("sph_quintic", "the quintic spline", 1.5),
      sph_with<sph::WendlandC2, KickDriftKick>("sph_without_diffusion", "no diffusion of density", 2,
                                               [](const Newtonian&, double) { return sph::Parts(sph::PressureSum{}); }),
      sph_moved_by<PredictorCorrector>("sph_predictor_corrector", "the midpoint rule"),
      sph_moved_by<AdamsBashforth>("sph_adams_bashforth", "third-order Adams-Bashforth"),
  };
}

}  // namespace touchstone::vnv
