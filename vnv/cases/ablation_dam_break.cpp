/// Ablation study of the dam break: one ingredient of each method at a time is removed or added.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/fluids/tait.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "solvers/mpm/walls/velocity_reset.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/walls/free_slip.hpp"
#include "vnv/flows/dam_front.hpp"
#include "vnv/stability/ablation.hpp"

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

constexpr double l0 = 0.6, h0 = 0.6, tank_length = 1.61, tank_height = 1.2;  // m
constexpr double g = 9.8;                                                    // m/s²
constexpr double cell = 0.02;                                                // m

/// The dam break of Sun et al., section 3.3, of a fluid with or without viscosity.
template <class FluidLaw>
Scene<FluidLaw, Uniform> collapse_of(const FluidLaw& fluid) {
  return {.domain = {.box = {.high = {tank_length, tank_height}}},
          .fluid = fluid,
          .filled = {.high = {l0, h0}},
          .walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(tank_length, free_slip())},
          .body_force = {{0, -g}}};
}
constexpr Tait inviscid{.density = 1000, .bulk_modulus = 0.36 * MPa};
constexpr Newtonian viscous{inviscid, 1e-3};

const DamFront front{.column_length = l0,
                     .column_height = h0,
                     .tank_length = tank_length,
                     .tank_height = tank_height,
                     .density = inviscid.density,
                     .gravity = g,
                     .slab = cell};

/// The front runs at most at 2 sqrt(g h0) = 4.9 m/s; at twice that the run counts as diverged.
const StepSearch search{.low = 5 * us, .high = 5000 * us, .tolerance = 0.02, .steps = 1000, .speed_limit = 10};

/// A variant of a method, by how a solver is made for a level and a time step [s].
template <class Factory>
Variant variant(std::string name, double time_step, Factory solver) {
  return {std::move(name), [=](const Level& level, const Schedule& when) {
            return run_and_search([&](double step) { return solver(level, step); }, time_step, when, search);
          }};
}

template <class WallTreatment, class FluidLaw>
Variant mpm_variant(std::string name, const FluidLaw& fluid) {
  return variant(std::move(name), 50 * us, [=](const Level& level, double step) {
    return mpm::solver<WallTreatment>(collapse_of(fluid),
                                      {.cell = level.cell, .spacing = level.spacing, .time_step = step});
  });
}

const auto mean_pressure = [](double) { return sph::Pressure{}; };
const auto artificial = [](double h) {
  return sph::ArtificialViscosity{.alpha = 0.01, .sound_speed = inviscid.sound_speed(), .h = h};
};
const auto laminar = [](double h) {
  return sph::LaminarViscosity{.nu = viscous.kinematic_viscosity(), .eta = 0.1 * h};
};

/// The printed method with these terms, each a function of the smoothing length, and without what `Left` names.
template <class Left = sph::Without<>, class... Terms>
Variant sph_variant(std::string name, Terms... terms) {
  return variant(std::move(name), 25 * us, [=](const Level& level, double step) {
    const double h = 1.2 * level.spacing;
    return sph::printed<sph::CubicSpline, PredictorCorrector, double, Left>(
        collapse_of(inviscid), {.spacing = level.spacing, .smoothing_length = h, .time_step = step},
        sph::momentum(terms(h)...));
  });
}

const std::string viscosity_of_water = "with the viscosity of water";

const Claim near_the_experiment =
    at_most(front.rms, 0.12,
            baseline("an independent prototype of MPM as printed differed by 0.09 from Lobovský et al. 2014"))
        .on(unabridged);

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Dam break: ablation study",
      .description =
          "The collapse of a column of water 0.6 m square, with each method complete and with one ingredient at a time "
          "removed or added. The error is the RMS distance of the front from that of Lobovský et al. (2014); the "
          "largest stable step is found by bisection over the first 1000 steps.",
      .times = {0.5},
      .watch = {.every = 0.01,
                .see = [](const Samples& s) { return front.look(s); },
                .quantities = DamFront::monitored},
      .measurements = {[](const Level& level, const Run& run) { return front.compare(level, run); }},
      .methods =
          {ablation(
               {.name = "mpm",
                .description =
                    "Material point method as printed, linear shape functions, cells of 0.02 m, 4 particles per cell.",
                .claims = {near_the_experiment}},
               {.spacing = cell / 2, .cell = cell, .report = 0.5, .nightly = 0.5},
               {mpm_variant<mpm::PrescribedMotion>(unabridged, inviscid),
                mpm_variant<mpm::VelocityReset>("walls reset the velocity", inviscid),
                mpm_variant<mpm::PrescribedMotion>(viscosity_of_water, viscous)}),
           ablation(
               {.name = "sph",
                .description = "Smoothed particle hydrodynamics as printed, spacing 0.02 m.",
                .claims = {near_the_experiment}},
               {.spacing = cell, .report = 0.5, .nightly = 0.5},
               {sph_variant(unabridged, mean_pressure, artificial),
                sph_variant("without artificial viscosity", mean_pressure),
                sph_variant<sph::Without<sph::Restoration>>("without restored density", mean_pressure, artificial),
                sph_variant<sph::Without<sph::Repulsion>>("without repulsive particles", mean_pressure, artificial),
                sph_variant(viscosity_of_water, mean_pressure, artificial, laminar)})},
      .plots = {ablation_table(front.rms, {viscosity_of_water})},
  };
}
