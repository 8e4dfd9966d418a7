#pragma once
/// How the methods of SPH for free surfaces are set up, for the sources of this folder that compile them.

#include "solvers/sph/free_surface/diffusion/antuono.hpp"
#include "solvers/sph/free_surface/free_surface.hpp"
#include "solvers/sph/free_surface/gradients/bonet_lok.hpp"
#include "solvers/sph/free_surface/shifting/tangential.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/bonet_lok_pressure.hpp"
#include "solvers/sph/terms/monaghan_cleary_viscosity.hpp"
#include "vnv/methods/free_surface_methods.hpp"

namespace touchstone::vnv {

template <class FluidLaw>
sph::Antuono diffusion_in(const FluidLaw& fluid, double h) {
  return {.delta = 0.1, .sound_speed = fluid.sound_speed(), .h = h};
}

/// The parts of a method in a fluid, by smoothing length and spacing [m].
struct OfDelta {
  static auto parts(const auto& fluid, double h, double) {
    return sph::Parts(sph::PressureSum{}, diffusion_in(fluid, h));
  }
};
struct OfShifted {
  static auto parts(const auto& fluid, double h, double spacing) {
    return sph::Parts(sph::PressureSum{}, diffusion_in(fluid, h), sph::PlainGradient{},
                      sph::TangentialShifting{spacing});
  }
};
struct OfCorrected {
  static auto parts(const auto& fluid, double h, double) {
    return sph::Parts(sph::BonetLokPressure{}, diffusion_in(fluid, h), sph::BonetLok{});
  }
};

template <class FluidLaw>
auto viscosity_of(const FluidLaw& fluid, double alpha, double h) {
  if constexpr (Viscous<FluidLaw>)
    return sph::momentum(sph::MonaghanClearyViscosity{.mu = fluid.viscosity});
  else
    return sph::momentum(sph::ArtificialViscosity{.alpha = alpha, .sound_speed = fluid.sound_speed(), .h = h});
}

/// A solver with those parts; `Wrap` may add to them.
template <class Of, class Integrator = KickDriftKick, template <class> class Wrap = std::type_identity_t,
          class AnyScene>
auto sph_solver(const AnyScene& scene, const Level& level, double time_step, const SphChoice& choice) {
  const double h = level.smoothing_or(choice.ratio * level.spacing);
  const auto parts = Of::parts(scene.fluid, h, level.spacing);
  return sph::free_surface<sph::WendlandC2, Integrator>(
      scene, {.spacing = level.spacing, .smoothing_length = h, .time_step = time_step},
      viscosity_of(scene.fluid, choice.alpha, h), Wrap<std::remove_const_t<decltype(parts)>>{parts});
}

}  // namespace touchstone::vnv
