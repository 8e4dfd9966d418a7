/// Ablation study of Poiseuille flow: one ingredient of each method at a time is removed or replaced.

#include "solvers/integrators/kick_drift_kick.hpp"
#include "solvers/integrators/predictor_corrector.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "solvers/sph/transport_velocity/transport_velocity.hpp"
#include "vnv/flows/channels/driven_channel.hpp"
#include "vnv/stability/ablation.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

constexpr double end = 0.5;     // s  the flow has 99.3 % of its steady velocity
constexpr double long_end = 5;  // s  neighbouring rows have slipped past each other by fifty spacings

const Scene<Newtonian, ForceField> scene = driven_by(perturbed_drive(1e-4));

const StepSearch search{.low = 0.5 * us, .high = 1000 * us, .speed_limit = too_fast};

template <class WallTreatment>
Variant mpm_variant(std::string name) {
  return variant(std::move(name), 4 * dt, search,
                 [](const Level& level, double step) { return mpm_solver<WallTreatment>(scene, level, step); });
}

/// Terms of the printed method for its smoothing length h [m].
const auto laminar = [](double h) { return sph::LaminarViscosity{.nu = water.kinematic_viscosity(), .eta = 0.1 * h}; };
const auto artificial = [](double h) {
  return sph::ArtificialViscosity{.alpha = 0.01, .sound_speed = water.sound_speed(), .h = h};
};

/// The printed method with these terms, each a function of the smoothing length, and without what `Left` names.
template <class Left = sph::Without<>, class... Terms>
Variant printed_variant(std::string name, Terms... terms) {
  return variant(std::move(name), 4 * dt, search, [=](const Level& level, double step) {
    const double h = 1.2 * level.spacing;
    return sph::printed<sph::CubicSpline, PredictorCorrector, double, Left>(
        scene, {.spacing = level.spacing, .smoothing_length = h, .time_step = step}, sph::momentum(terms(h)...));
  });
}

/// The regularised method with these terms, and without what `Left` names.
template <class Left = sph::Without<sph::DriftMomentum>, class... Terms>
Variant regularised_variant(std::string name, Terms... terms) {
  return variant(std::move(name), 4 * dt, search, [=](const Level& level, double step) {
    return sph::transport_velocity<sph::QuinticSpline, KickDriftKick, double, Left>(
        scene, {.spacing = level.spacing, .smoothing_length = level.spacing, .time_step = step},
        sph::momentum(terms...));
  });
}

const auto conservative = [](double) { return sph::Pressure{}; };
const auto difference = [](double) { return sph::PressureDifference{}; };
const sph::MorrisViscosity morris{.mu = water.viscosity};

const std::string with_momentum = "with the momentum of the drift";

const Level coarse{.spacing = H / 20, .report = end, .nightly = end};
const Level coarse_and_long{.spacing = H / 20, .report = end, .nightly = long_end};
const Level coarse_grid{.spacing = H / 40, .cell = H / 20, .report = end, .nightly = end};

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Poiseuille flow: ablation study",
      .description =
          "Each method runs Poiseuille flow from rest to 0.5 s at 20 particles or cells across the gap, complete and "
          "with one ingredient at a time removed. The body force is perturbed by one part in ten thousand, so that an unstable "
          "variant is detected. What keeps the particle distribution regular pays off only over many seconds: the "
          "nightly suite runs the regularised method, the recommended one for a channel, to 5 s. The method as printed "
          "is kept complete, as in the paper's comparison. The largest stable step is found by bisection, 2000 steps "
          "per trial.",
      .times = {end, long_end},
      .measurements = {norms_of("v_x, per particle", by_particles, flow_named("poiseuille").along_x())},
      .methods = {ablation({.name = "mpm",
                            .description = mpm_words + moving_words,
                            .claims = {at_most(l2, 0.5, theory("order 2: a quarter of a percent at 20 cells"))
                                           .on(unabridged)}},
                           coarse_grid,
                           {mpm_variant<mpm::PrescribedMotion>(unabridged),
                            mpm_variant<mpm::VelocityReset>("walls reset the velocity"),
                            mpm_variant<mpm::PrescribedVelocity>("no wall acceleration")}),
                  ablation({.name = "sph",
                            .description = sph_printed_words + conservative_words,
                            .claims = {at_most(l2, 4.39, literature("Sun et al., table 3, S1")).on(unabridged)}},
                           coarse,
                           {printed_variant(unabridged, conservative, laminar, artificial),
                            printed_variant("without artificial viscosity", conservative, laminar),
                            printed_variant("without laminar viscosity", conservative, artificial),
                            printed_variant("without pressure", laminar, artificial),
                            printed_variant<sph::Without<sph::DensityReinitialisation>>(
                                "without Shepard density reinitialisation", conservative, laminar, artificial),
                            printed_variant<sph::Without<sph::Repulsion>>("without repulsive particles", conservative,
                                                                          laminar, artificial),
                            printed_variant("differences of pressure", difference, laminar, artificial)}),
                  ablation({.name = "sph_regularised",
                            .description = sph_regularised_words,
                            .claims = {at_most(l2, 1, baseline("0.55 at 20 across and 1 s")).on(unabridged)}},
                           coarse_and_long,
                           {regularised_variant(unabridged, sph::PressureDifference{}, morris),
                            regularised_variant("without pressure", morris),
                            regularised_variant("without laminar viscosity", sph::PressureDifference{}),
                            regularised_variant<sph::Without<sph::VolumeConstraint, sph::DriftMomentum>>(
                                "without volume constraint", sph::PressureDifference{}, morris),
                            regularised_variant<sph::Without<sph::BackgroundPressure, sph::DriftMomentum>>(
                                "without background pressure", sph::PressureDifference{}, morris),
                            regularised_variant<sph::Without<>>(with_momentum, sph::PressureDifference{}, morris),
                            regularised_variant("conservative pressure", sph::Pressure{}, morris)})},
      .plots = {ablation_table(l2, {with_momentum})},
  };
}
