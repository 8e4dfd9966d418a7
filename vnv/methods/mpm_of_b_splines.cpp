#include "vnv/methods/free_surface_methods.hpp"

#include "solvers/mpm/lanes/in_lanes.hpp"
#include "vnv/methods/scenes.hpp"

namespace touchstone::vnv {

template <class Transfer, class AnyScene>
Simulation mpm_of_b_splines_solver(const AnyScene& scene, const Level& level, double time_step) {
  return mpm::in_lanes<mpm::BSpline<2>, Transfer, mpm::AffineDensity>(
      scene, {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
}

namespace {
template <class Transfer, class AnyScene>
Method mpm_of_b_splines(const AnyScene& scene, double output_interval, const std::string& name,
                        const std::string& transfer) {
  return keeping_courant_number(
      0.5, output_interval, scene, mpm_of_b_splines_solver<Transfer, AnyScene>,
      {.name = name,
       .family = Family::mpm,
       .description = fmt::format(
           "Material point method with quadratic B-splines modified at walls, MUSL, {}, and densities that are "
           "smoothed over the nodes while preserving hydrostatic gradients; four particles per cell.",
           transfer),
       .relative_cost = 2});
}
}  // namespace

Method mpm_apic(const auto& scene, double output_interval) {
  return mpm_of_b_splines<mpm::Apic>(scene, output_interval, "mpm_apic",
                                     "affine particle velocities (APIC, Jiang et al. 2015)");
}

Method mpm_xpic(const auto& scene, double output_interval) {
  return mpm_of_b_splines<mpm::Xpic<5>>(scene, output_interval, "mpm_xpic",
                                        "velocities by XPIC(5) (Hammerquist & Nairn 2017)");
}

#define TOUCHSTONE_COMPILE(...)                         \
  template Method mpm_apic(const __VA_ARGS__&, double); \
  template Method mpm_xpic(const __VA_ARGS__&, double);
TOUCHSTONE_FREE_SURFACE_SCENES(TOUCHSTONE_COMPILE)
template Method mpm_apic(const Scene<Tait, SkinFriction>&, double);
template Method mpm_apic(const Scene<Tait, Rolling>&, double);

}  // namespace touchstone::vnv
