#include "vnv/methods/scenes.hpp"
#include "vnv/methods/sph_of_parts.hpp"

namespace touchstone::vnv {

namespace {
const std::string diffusion_words = "density diffusion with renormalised gradient, delta = 0.1 (Antuono et al. 2010)";

template <class Parts, class AnyScene>
Method sph_of_parts(const AnyScene& scene, double output_interval, const std::string& name, const std::string& words,
                    const SphChoice& choice) {
  const std::string viscosity =
      Viscous<decltype(scene.fluid)> ? "" : fmt::format("artificial viscosity {:g}, ", choice.alpha);
  return simulating(
      {.name = name,
       .family = Family::sph,
       .description = fmt::format(
           "Smoothed particle hydrodynamics for free surfaces: {}, {}walls after Adami, Hu & Adams (2012), "
           "Wendland's C2 kernel with h = {:g} spacings, kick-drift-kick. Acoustic Courant number {:g}, based on h.",
           words, viscosity, choice.ratio, choice.courant),
       .tolerance = stretched,
       .relative_cost = 4},
      [=](const Level& level, double time_step) {
        return sph_solver<Parts>(scene_at(level, scene), level, time_step, choice);
      },
      [=](const Level& level) {
        const double h = level.smoothing_or(choice.ratio * level.spacing);
        return step_for(scene_at(level, scene), choice.courant * h / level.spacing, level.spacing, output_interval);
      });
}
}  // namespace

Method sph_delta(const auto& scene, double output_interval, const SphChoice& choice) {
  return sph_of_parts<OfDelta>(scene, output_interval, "sph_delta",
                               diffusion_words + ", symmetric pressure term p_i + p_j", choice);
}

Method sph_shifted(const auto& scene, double output_interval, const SphChoice& choice) {
  return sph_of_parts<OfShifted>(
      scene, output_interval, "sph_shifted",
      diffusion_words +
          ", symmetric pressure term p_i + p_j, particle shifting, tangential at a free surface (Sun et al. 2017)",
      choice);
}

Method sph_corrected(const auto& scene, double output_interval, const SphChoice& choice) {
  return sph_of_parts<OfCorrected>(scene, output_interval, "sph_corrected",
                                   "gradients corrected after Bonet & Lok (1999), " + diffusion_words, choice);
}

#define TOUCHSTONE_COMPILE(...)                                                \
  template Method sph_delta(const __VA_ARGS__&, double, const SphChoice&);     \
  template Method sph_corrected(const __VA_ARGS__&, double, const SphChoice&); \
  template Method sph_shifted(const __VA_ARGS__&, double, const SphChoice&);
TOUCHSTONE_FREE_SURFACE_SCENES(TOUCHSTONE_COMPILE)

}  // namespace touchstone::vnv
