#include "vnv/methods/free_surface_methods.hpp"

#include "solvers/sph/free_surface/diffusion/antuono.hpp"
#include "solvers/sph/free_surface/free_surface.hpp"
#include "solvers/sph/free_surface/gradients/bonet_lok.hpp"
#include "solvers/sph/free_surface/shifting/tangential.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/bonet_lok_pressure.hpp"
#include "solvers/sph/terms/monaghan_cleary_viscosity.hpp"
#include "vnv/methods/scenes.hpp"

namespace touchstone::vnv {

namespace {
template <class FluidLaw>
auto viscosity_of(const FluidLaw& fluid, double alpha, double h) {
  if constexpr (Viscous<FluidLaw>)
    return sph::momentum(sph::MonaghanClearyViscosity{.mu = fluid.viscosity});
  else
    return sph::momentum(sph::ArtificialViscosity{.alpha = alpha, .sound_speed = fluid.sound_speed(), .h = h});
}

const std::string diffusion_words = "density diffusion with renormalised gradient, delta = 0.1 (Antuono et al. 2010)";
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
       .family = Family::sph,
       .description = fmt::format(
           "Smoothed particle hydrodynamics for free surfaces: {}, {}walls after Adami, Hu & Adams (2012), "
           "Wendland's C2 kernel with h = {:g} spacings, kick-drift-kick. Acoustic Courant number {:g}, by h.",
           words, viscosity, choice.ratio, choice.courant),
       .tolerance = stretched,
       .relative_cost = 4},
      [=](const Level& level, double time_step) {
        const double h = level.smoothing_or(choice.ratio * level.spacing);
        const auto fluid = scene_at(level, scene).fluid;
        return sph::free_surface<sph::WendlandC2>(
            scene_at(level, scene), {.spacing = level.spacing, .smoothing_length = h, .time_step = time_step},
            viscosity_of(fluid, choice.alpha, h), parts(fluid, h, level.spacing));
      },
      [=](const Level& level) {
        const double h = level.smoothing_or(choice.ratio * level.spacing);
        return step_for(scene_at(level, scene), choice.courant * h / level.spacing, level.spacing, output_interval);
      });
}
}  // namespace

template <class AnyScene>
Method sph_delta(const AnyScene& scene, double output_interval, const SphChoice& choice) {
  return sph_of_parts(scene, output_interval, "sph_delta", diffusion_words + ", symmetric pressure term p_i + p_j",
                      choice, [](const auto& fluid, double h, double) {
                        return sph::Parts{.pressure = sph::PressureSum{}, .diffusion = diffusion_in(fluid, h)};
                      });
}

template <class AnyScene>
Method sph_shifted(const AnyScene& scene, double output_interval, const SphChoice& choice) {
  return sph_of_parts(
      scene, output_interval, "sph_shifted",
      diffusion_words +
          ", symmetric pressure term p_i + p_j, particle shifting, tangential at a free surface (Sun et al. 2017)",
      choice, [](const auto& fluid, double h, double spacing) {
        return sph::Parts{.pressure = sph::PressureSum{},
                          .diffusion = diffusion_in(fluid, h),
                          .gradient = sph::PlainGradient{},
                          .shifting = sph::TangentialShifting{spacing}};
      });
}

template <class AnyScene>
Method sph_corrected(const AnyScene& scene, double output_interval, const SphChoice& choice) {
  return sph_of_parts(
      scene, output_interval, "sph_corrected", "gradients corrected after Bonet & Lok (1999), " + diffusion_words,
      choice, [](const auto& fluid, double h, double) {
        return sph::Parts{
            .pressure = sph::BonetLokPressure{}, .diffusion = diffusion_in(fluid, h), .gradient = sph::BonetLok{}};
      });
}

#define TOUCHSTONE_COMPILE(...)                                                \
  template Method sph_delta(const __VA_ARGS__&, double, const SphChoice&);     \
  template Method sph_corrected(const __VA_ARGS__&, double, const SphChoice&); \
  template Method sph_shifted(const __VA_ARGS__&, double, const SphChoice&);
TOUCHSTONE_FREE_SURFACE_SCENES(TOUCHSTONE_COMPILE)

}  // namespace touchstone::vnv
