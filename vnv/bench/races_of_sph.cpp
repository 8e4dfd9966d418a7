#include "solvers/integrators/adams_bashforth.hpp"
#include "solvers/integrators/predictor_corrector.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/second_order/second_order.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/transport_velocity/transport_velocity.hpp"
#include "vnv/bench/plain_sph.hpp"
#include "vnv/bench/race.hpp"
#include "vnv/bench/scenes.hpp"
#include "vnv/flows/channels/channel.hpp"
#include "vnv/methods/sph_of_parts.hpp"

namespace touchstone::bench {
namespace {

using namespace vnv;

/// Of two terms, pressure and the viscosity of the fluid or, if it has none, an artificial one.
template <class Integrator = PredictorCorrector, class FluidLaw, class Force>
auto printed_sph(const Scene<FluidLaw, Force>& scene, const Level& level, double time_step, int threads = 1) {
  const double h = 1.2 * level.spacing;
  const auto viscosity = [&] {
    if constexpr (Viscous<FluidLaw>)
      return sph::LaminarViscosity{.nu = scene.fluid.kinematic_viscosity(), .eta = 0.1 * h};
    else
      return sph::ArtificialViscosity{.alpha = 0.01, .sound_speed = scene.fluid.sound_speed(), .h = h};
  }();
  return sph::printed<sph::CubicSpline, Integrator>(
      scene, {.spacing = level.spacing, .smoothing_length = h, .time_step = time_step, .threads = threads},
      sph::momentum(sph::Pressure{}, viscosity));
}

/// The printed method against the plain loop, which has laminar viscosity.
template <class Integrator = PredictorCorrector, class AnyScene>
auto race_sph(const AnyScene& scene, double time_step) {
  constexpr int evaluations = std::is_same_v<Integrator, PredictorCorrector> ? 2 : 1;
  return [=](const Level& level, const Schedule&) {
    return race_with_rates(printed_sph<Integrator>(scene, level, time_step),
                           PlainSph(plain(scene), level.spacing, time_step), evaluations);
  };
}

/// What `make`(scene, level, time step) makes, an accurate method, against the printed one; the median of three tries.
template <class AnyScene, class Make>
Method against_printed(const std::string& name, const std::string& words, const AnyScene& scene, double time_step,
                       Make make) {
  return {.name = name,
          .description = words +
                         ": its right-hand side is timed alternately with that of the printed method, which has 20 "
                         "listed neighbours and one pass over the pairs.",
          .run = [=](const Level& level, const Schedule&) {
            return tries(3, slower_rates, [&] {
              return race_with_printed(make(scene, level, time_step), printed_sph(scene, level, time_step), 100);
            })[1];
          }};
}

/// SPH for free surfaces in the dam break.
template <class Parts>
Method race_in_dam(const std::string& name, const std::string& words) {
  return against_printed(name, words, dam(), 4 * dam_sph_step,
                         [](const auto& scene, const Level& level, double time_step) {
                           return sph_solver<Parts>(scene, level, time_step, {.alpha = 0.01});
                         });
}

/// A method in the channel, and in vortices with 64 particles across.
template <class Make>
void race_in_channel_and_square(std::vector<Method>& races, const std::string& name, const std::string& words,
                                const std::string& passes, Make make) {
  races.push_back(against_printed(name, words + " in Poiseuille flow" + passes, channel(), channel_step, make));
  races.push_back(against_printed(name + "_square", words + " in vortices" + passes, vortices(),
                                  0.2 / 64 / vortices().fluid.sound_speed(), make));
}

}  // namespace

std::vector<Method> races_of_sph() {
  const std::string in_column =
      "Smoothed particle hydrodynamics as printed, in the dam break; the plain loop has the same column but no walls, "
      "and laminar instead of artificial viscosity.";
  std::vector<Method> races{
      {.name = "sph",
       .description = vnv::channel::sph_printed_words +
                      " With pressure and laminar viscosity only, timed in Poiseuille flow against a scalar loop over "
                      "full neighbour lists. The rate is also scaled to the machine on which the other codes were "
                      "measured, where the right-hand side of that loop takes 114 ns.",
       .run = race_sph(channel(), channel_step)},
      {.name = "sph_dam_break", .description = in_column, .run = race_sph(dam(), dam_sph_step)},
      {.name = "sph_one_evaluation",
       .description = "Smoothed particle hydrodynamics as printed, but by Adams-Bashforth with one right-hand side "
                      "per step, in Poiseuille flow.",
       .run = race_sph<AdamsBashforth>(channel(), channel_step)},
      {.name = "sph_one_evaluation_dam_break",
       .description = in_column + " By Adams-Bashforth, with one right-hand side per step.",
       .run = race_sph<AdamsBashforth>(dam(), dam_sph_step)},
      race_in_dam<OfDelta>("sph_delta", "delta-SPH in the dam break, 47 to 58 neighbours, two passes"),
      race_in_dam<OfCorrected>("sph_corrected", "delta-SPH with corrected gradients in the dam break"),
      race_in_dam<OfShifted>("sph_shifted", "delta-SPH with shifted particles in the dam break"),
      {.name = "sph_threads",
       .description = "Smoothed particle hydrodynamics" + words_of_threads,
       .run = compare_threads([](const Level& level, int threads) {
         return printed_sph(channel(8 * channel_length), level, channel_step, threads);
       })}};
  race_in_channel_and_square(
      races, "sph_second_order", "Smoothed particle hydrodynamics of second order", "",
      [](const auto& scene, const Level& level, double time_step) {
        return sph::second_order<sph::WendlandC2>(
            scene, {.spacing = level.spacing, .smoothing_length = 1.3 * level.spacing, .time_step = time_step});
      });
  race_in_channel_and_square(
      races, "sph_transport_velocity", "Transport-velocity SPH", ", two passes",
      [](const auto& scene, const Level& level, double time_step) {
        return sph::transport_velocity<sph::QuinticSpline>(
            scene, {.spacing = level.spacing, .smoothing_length = level.spacing, .time_step = time_step},
            sph::momentum(sph::Pressure{}, sph::MorrisViscosity{.mu = scene.fluid.viscosity}));
      });
  return races;
}

}  // namespace touchstone::bench
