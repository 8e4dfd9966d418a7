/// Ablation study of the dam break: one ingredient of each method at a time is removed or added.

#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "solvers/mpm/walls/velocity_reset.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "vnv/flows/dam_break.hpp"
#include "vnv/stability/ablation.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::dam_break;

namespace {

constexpr Newtonian viscous{water, 1e-3};

/// The front runs at most at 2 sqrt(g h0) = 4.9 m/s; at twice that the run counts as diverged.
const StepSearch search{.low = 5 * us, .high = 5000 * us, .tolerance = 0.02, .steps = 1000, .speed_limit = 10};

template <class WallTreatment, class FluidLaw>
Variant mpm_variant(std::string name, const FluidLaw& fluid) {
  return variant(std::move(name), 50 * us, search, [=](const Level& level, double step) {
    return mpm::printed<WallTreatment>(collapse(column, tank, fluid),
                                      {.cell = level.cell, .spacing = level.spacing, .time_step = step});
  });
}

const auto conservative = [](double) { return sph::Pressure{}; };
const auto artificial = [](double h) {
  return sph::ArtificialViscosity{.alpha = 0.01, .sound_speed = water.sound_speed(), .h = h};
};
const auto laminar = [](double h) {
  return sph::LaminarViscosity{.nu = viscous.kinematic_viscosity(), .eta = 0.1 * h};
};

/// The printed method with these terms, each a function of the smoothing length, and without what `Left` names.
template <class Left = sph::Without<>, class... Terms>
Variant sph_variant(std::string name, Terms... terms) {
  return variant(std::move(name), 25 * us, search, [=](const Level& level, double step) {
    const double h = 1.2 * level.spacing;
    return sph::printed<sph::CubicSpline, PredictorCorrector, double, Left>(
        collapse(column, tank), {.spacing = level.spacing, .smoothing_length = h, .time_step = step},
        sph::momentum(terms(h)...));
  });
}

const std::string viscosity_of_water = "with the viscosity of water";

}  // namespace

Case vnv::the_case() {
  Case declared = front_followed(
      "Dam break: ablation study",
      "The collapse of a column of water 0.6 m square, with each method complete and with one ingredient at a time "
      "removed or added. The error is the RMS distance of the front from that of Lobovský et al. (2014); the "
      "largest stable step is found by bisection over the first 1000 steps.");
  declared.methods = {
      ablation({.name = "mpm",
                .description =
                    "Material point method as printed, linear shape functions, cells of 0.02 m, 4 particles per cell.",
                .claims = {near_the_experiment.on(unabridged)}},
               {.spacing = cell / 2, .cell = cell, .report = 0.5, .nightly = 0.5},
               {mpm_variant<mpm::PrescribedMotion>(unabridged, water),
                mpm_variant<mpm::VelocityReset>("walls reset the velocity", water),
                mpm_variant<mpm::PrescribedMotion>(viscosity_of_water, viscous)}),
      ablation({.name = "sph",
                .description = "Smoothed particle hydrodynamics as printed, spacing 0.02 m.",
                .claims = {near_the_experiment.on(unabridged)}},
               {.spacing = cell, .report = 0.5, .nightly = 0.5},
               {sph_variant(unabridged, conservative, artificial),
                sph_variant("without artificial viscosity", conservative),
                sph_variant<sph::Without<sph::DensityReinitialisation>>("without Shepard density reinitialisation",
                                                                        conservative, artificial),
                sph_variant<sph::Without<sph::Repulsion>>("without repulsive particles", conservative, artificial),
                sph_variant(viscosity_of_water, conservative, artificial, laminar)})};
  declared.plots = {ablation_table(front.rms, {viscosity_of_water})};
  return declared;
}
