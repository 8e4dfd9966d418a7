#pragma once
/// Methods made of parts (solvers/mpm/composed/composed.hpp, solvers/sph/free_surface/free_surface.hpp), as flows with
/// a free surface run them.

#include "solvers/fluids/tait.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/mpm/composed/composed.hpp"
#include "solvers/mpm/composed/densities/affine_density.hpp"
#include "solvers/mpm/composed/transfers/apic.hpp"
#include "solvers/mpm/composed/transfers/xpic.hpp"
#include "solvers/mpm/composed/updates/modified_stress_last.hpp"
#include "solvers/mpm/shapes/b_spline.hpp"
#include "solvers/sph/free_surface/diffusion/antuono.hpp"
#include "solvers/sph/free_surface/free_surface.hpp"
#include "solvers/sph/free_surface/gradients/bonet_lok.hpp"
#include "solvers/sph/free_surface/shifting/tangential.hpp"
#include "solvers/sph/terms/bonet_lok_pressure.hpp"
#include "solvers/sph/terms/monaghan_cleary_viscosity.hpp"
#include "vnv/methods/methods.hpp"

namespace touchstone::vnv {

/// With quadratic B-splines, MUSL and affine densities; `share` of a cell is what sound travels in a step.
template <class Transfer, class AnyScene>
Method mpm_of_b_splines(const AnyScene& scene, double output_interval, const std::string& name,
                        const std::string& transfer, double share = 0.5) {
  return simulating(
      {.name = name,
       .description = fmt::format(
           "Material point method with quadratic B-splines that are right at walls, MUSL, {}, and densities that are "
           "smoothed over the nodes without flattening a pressure that bears weight; four particles in a cell. Sound "
           "travels {:g} cells in a step.",
           transfer, share),
       .tolerance = stretched,
       .relative_cost = 2},
      [=](const Level& level, double time_step) {
        return mpm::composed<mpm::BSpline<2>, Transfer, mpm::ModifiedStressLast, mpm::AffineDensity>(
            scene, {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
      },
      by_cells(scene, share, output_interval));
}

template <class AnyScene>
Method mpm_apic(const AnyScene& scene, double output_interval) {
  return mpm_of_b_splines<mpm::Apic>(scene, output_interval, "mpm_apic",
                                     "affine particle velocities (APIC, Jiang et al. 2015)");
}
template <class AnyScene>
Method mpm_xpic(const AnyScene& scene, double output_interval) {
  return mpm_of_b_splines<mpm::Xpic<5>>(scene, output_interval, "mpm_xpic",
                                        "velocities by XPIC(5) (Hammerquist & Nairn 2017)");
}

/// What a method of smoothed particle hydrodynamics for free surfaces may be told besides its parts.
struct SphChoice {
  double ratio = 2;     // -  h over the spacing
  double alpha = 0.02;  // -  artificial viscosity, where the fluid has none of its own
  double share = 0.5;   // -  of h, that sound travels in a step
};

namespace detail {
template <class FluidLaw>
auto viscosity_of(const FluidLaw& fluid, double alpha, double h) {
  if constexpr (Viscous<FluidLaw>)
    return sph::momentum(sph::MonaghanClearyViscosity{.mu = fluid.viscosity});
  else
    return sph::momentum(sph::ArtificialViscosity{.alpha = alpha, .sound_speed = fluid.sound_speed(), .h = h});
}

template <class FluidLaw>
sph::Antuono diffusion_in(const FluidLaw& fluid, double h) {
  return {.delta = 0.1, .sound_speed = fluid.sound_speed(), .h = h};
}

template <class MakeParts, class AnyScene>
Method sph_of_parts(const AnyScene& scene, double output_interval, const std::string& name, const std::string& words,
                    const SphChoice& choice, const MakeParts& parts) {
  const std::string viscosity =
      Viscous<decltype(scene.fluid)> ? "" : fmt::format("artificial viscosity {:g}, ", choice.alpha);
  return simulating(
      {.name = name,
       .description = fmt::format(
           "Smoothed particle hydrodynamics for free surfaces: {}, {}walls after Adami, Hu & Adams (2012), Wendland's C2 "
           "kernel with h = {:g} spacings, kick-drift-kick. Sound travels {:g} h in a step.",
           words, viscosity, choice.ratio, choice.share),
       .tolerance = stretched,
       .relative_cost = 4},
      [=](const Level& level, double time_step) {
        const double h = level.smoothing_or(choice.ratio * level.spacing);
        return sph::free_surface<sph::WendlandC2>(
            scene, {.spacing = level.spacing, .smoothing_length = h, .time_step = time_step},
            viscosity_of(scene.fluid, choice.alpha, h), parts(scene.fluid, h));
      },
      [=](const Level& level) {
        const double h = level.smoothing_or(choice.ratio * level.spacing);
        return step_for(scene, choice.share * h / level.spacing, level.spacing, output_interval);
      });
}
}  // namespace detail

/// delta-SPH [Antuono et al. 2010].
template <class AnyScene>
Method sph_delta(const AnyScene& scene, double output_interval, const SphChoice& choice = {}) {
  return detail::sph_of_parts(
      scene, output_interval, "sph_delta",
      "diffusion of density less its linear part with delta = 0.1 (Antuono et al. 2010), sums of pressures", choice,
      [](const auto& fluid, double h) {
        return sph::Parts{.pressure = sph::PressureSum{}, .diffusion = detail::diffusion_in(fluid, h)};
      });
}

/// The same with particles that are shifted from where they are crowded [Lind et al. 2012; Sun et al. 2017].
template <class AnyScene>
Method sph_shifted(const AnyScene& scene, double output_interval, const SphChoice& choice = {}) {
  return detail::sph_of_parts(
      scene, output_interval, "sph_shifted",
      "diffusion of density less its linear part with delta = 0.1 (Antuono et al. 2010), sums of pressures, particles "
      "shifted from where they are crowded, along a surface only (Sun et al. 2017)",
      choice, [](const auto& fluid, double h) {
        return sph::Parts{.pressure = sph::PressureSum{},
                          .diffusion = detail::diffusion_in(fluid, h),
                          .gradient = sph::PlainGradient{},
                          .shifting = sph::TangentialShifting{}};
      });
}

/// delta-SPH with gradients of the kernel that are exact for linear fields.
template <class AnyScene>
Method sph_corrected(const AnyScene& scene, double output_interval, const SphChoice& choice = {}) {
  return detail::sph_of_parts(
      scene, output_interval, "sph_corrected",
      "gradients corrected after Bonet & Lok (1999), diffusion of density less its linear part with delta = 0.1 (Antuono et "
      "al. 2010)",
      choice, [](const auto& fluid, double h) {
        return sph::Parts{.pressure = sph::BonetLokPressure{},
                          .diffusion = detail::diffusion_in(fluid, h),
                          .gradient = sph::BonetLok{}};
      });
}

// Compiled once, in free_surface_methods.cpp.
#define TOUCHSTONE_FREE_SURFACE_METHODS(declare, ...)                     \
  declare Method mpm_as_printed(const __VA_ARGS__&, double, double);      \
  declare Method mpm_affine(const __VA_ARGS__&, double, double);          \
  declare Method mpm_apic(const __VA_ARGS__&, double);                    \
  declare Method mpm_xpic(const __VA_ARGS__&, double);                    \
  declare Method sph_as_printed(const __VA_ARGS__&, double, double);      \
  declare Method sph_delta(const __VA_ARGS__&, double, const SphChoice&); \
  declare Method sph_corrected(const __VA_ARGS__&, double, const SphChoice&);
TOUCHSTONE_FREE_SURFACE_METHODS(extern template, Scene<Tait>)
TOUCHSTONE_FREE_SURFACE_METHODS(extern template, Scene<Tait, Uniform>)
TOUCHSTONE_FREE_SURFACE_METHODS(extern template, Scene<Newtonian, Uniform>)

}  // namespace touchstone::vnv
