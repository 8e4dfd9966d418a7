#pragma once
/// The methods as any flow may run them, whose steps follow from how far sound travels. `output_interval` [s] holds a
/// whole number of steps; a level that names its own step or kernel has them.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/mpm/affine/affine.hpp"
#include "solvers/mpm/least_squares/least_squares.hpp"
#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/scene.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/second_order/second_order.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/transport_velocity/transport_velocity.hpp"
#include "vnv/methods/across.hpp"

#include <fmt/format.h>

namespace touchstone::vnv {

/// Flow that stretches its fluid, or whose rows slip past each other, doubles a rounding error every so often.
inline const Tolerance stretched{0.02, "tuned and portable builds differ by less"};

/// The step of a level in which sound travels a share of a cell, or of a spacing.
template <class AnyScene>
auto by_cells(const AnyScene& scene, double share, double output_interval) {
  return [=](const Level& level) { return step_for(scene, share, level.cell, output_interval); };
}
template <class AnyScene>
auto by_spacings(const AnyScene& scene, double share, double output_interval) {
  return [=](const Level& level) { return step_for(scene, share, level.spacing, output_interval); };
}

/// `share` of a cell is what sound travels in a step, here and below.
template <class AnyScene>
Method mpm_as_printed(const AnyScene& scene, double output_interval, double share = 0.5) {
  return simulating(
      {.name = "mpm",
       .description = fmt::format(
           "Material point method as printed by Sun et al., section 2.1: linear hats, lumped mass, FLIP, MUSL; four "
           "particles in a cell. Sound travels {:g} cells in a step.",
           share),
       .tolerance = stretched},
      [=](const Level& level, double time_step) {
        return mpm::solver<mpm::LinearHat, mpm::PrescribedMotion>(
            scene, {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
      },
      by_cells(scene, share, output_interval));
}

template <class AnyScene>
Method mpm_affine(const AnyScene& scene, double output_interval, double share = 0.8) {
  return simulating(
      {.name = "mpm_affine",
       .description = fmt::format(
           "Material point method with quadratic B-splines and affine particle velocities (APIC), four particles in a "
           "cell. Sound travels {:g} cells in a step; each step damps, so that long ones are the more accurate.",
           share),
       .tolerance = stretched},
      [=](const Level& level, double time_step) {
        return mpm::affine(scene, {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
      },
      by_cells(scene, share, output_interval));
}

/// For fluid that fills its domain.
template <class AnyScene>
Method mpm_least_squares(const AnyScene& scene, double output_interval, double share = 0.3) {
  return simulating(
      {.name = "mpm_least_squares",
       .description = fmt::format(
           "Material point method by least squares: nodes know the fluid by fits of second degree to its particles, the "
           "equations are solved by central differences on the nodes, particles are put back onto their lattice before "
           "it is strained by a quarter; third-order Adams-Bashforth, four particles in a cell. Sound travels {:g} cells "
           "in a step.",
           share),
       .tolerance = stretched},
      [=](const Level& level, double time_step) {
        return mpm::least_squares(scene, {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
      },
      by_cells(scene, share, output_interval));
}

namespace detail {
/// The terms of the printed method: without a laminar viscosity where the fluid has none.
template <class FluidLaw>
auto printed_terms(const FluidLaw& fluid, double h) {
  const sph::ArtificialViscosity artificial{.alpha = 0.01, .sound_speed = fluid.sound_speed(), .h = h};
  if constexpr (Viscous<FluidLaw>)
    return sph::momentum(sph::Pressure{}, sph::LaminarViscosity{.nu = fluid.kinematic_viscosity(), .eta = 0.1 * h},
                         artificial);
  else
    return sph::momentum(sph::Pressure{}, artificial);
}
}  // namespace detail

template <class AnyScene>
Method sph_as_printed(const AnyScene& scene, double output_interval, double share = 0.25) {
  return simulating(
      {.name = "sph",
       .description = fmt::format(
           "Smoothed particle hydrodynamics as printed by Sun et al., section 2.2, with the conservative pressure term "
           "and an artificial viscosity of 0.01. Sound travels {:g} spacings in a step.",
           share),
       .tolerance = stretched,
       .relative_cost = 2},
      [=](const Level& level, double time_step) {
        const double h = level.smoothing_or(1.2 * level.spacing);
        return sph::printed<sph::CubicSpline>(scene,
                                              {.spacing = level.spacing, .smoothing_length = h, .time_step = time_step},
                                              detail::printed_terms(scene.fluid, h));
      },
      by_spacings(scene, share, output_interval));
}

/// For fluid without a free surface.
template <class AnyScene>
Method sph_transport_velocity(const AnyScene& scene, double output_interval, double share = 0.25) {
  return simulating(
      {.name = "sph_transport_velocity",
       .description = fmt::format(
           "Smoothed particle hydrodynamics with a transport velocity (Adami, Hu & Adams 2013), quintic spline with h = "
           "1 spacing, density by continuity, conservative pressure. Sound travels {:g} spacings in a step.",
           share),
       .tolerance = stretched,
       .relative_cost = 2},
      [=](const Level& level, double time_step) {
        return sph::transport_velocity<sph::QuinticSpline>(
            scene,
            {.spacing = level.spacing, .smoothing_length = level.smoothing_or(level.spacing), .time_step = time_step},
            sph::momentum(sph::Pressure{}, sph::MorrisViscosity{.mu = scene.fluid.viscosity}));
      },
      by_spacings(scene, share, output_interval));
}

/// For fluid that fills its domain.
template <class AnyScene>
Method sph_second_order(const AnyScene& scene, double output_interval, double share = 0.3) {
  return simulating(
      {.name = "sph_second_order",
       .description = fmt::format(
           "Smoothed particle hydrodynamics of second order: fits of second degree to velocity and pressure around each "
           "particle, drift from where particles are dense, third-order Adams-Bashforth, Wendland's C2 kernel with h = "
           "1.3 spacings. Sound travels {:g} spacings in a step.",
           share),
       .tolerance = stretched,
       .relative_cost = 2},
      [=](const Level& level, double time_step) {
        return sph::second_order<sph::WendlandC2>(scene, {.spacing = level.spacing,
                                                          .smoothing_length = level.smoothing_or(1.3 * level.spacing),
                                                          .time_step = time_step});
      },
      by_spacings(scene, share, output_interval));
}

// A method takes ten seconds to compile for a scene: for scenes that several cases have it is done once, in
// methods.cpp.
#define TOUCHSTONE_METHODS(declare, ...)                                     \
  declare Method mpm_as_printed(const __VA_ARGS__&, double, double);         \
  declare Method mpm_affine(const __VA_ARGS__&, double, double);             \
  declare Method mpm_least_squares(const __VA_ARGS__&, double, double);      \
  declare Method sph_as_printed(const __VA_ARGS__&, double, double);         \
  declare Method sph_transport_velocity(const __VA_ARGS__&, double, double); \
  declare Method sph_second_order(const __VA_ARGS__&, double, double);
TOUCHSTONE_METHODS(extern template, Scene<Newtonian>)

}  // namespace touchstone::vnv
