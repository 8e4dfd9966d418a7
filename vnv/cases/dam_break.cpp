/// Dam break [Sun et al., section 3.3]. A column of water 0.6 m square collapses in a tank 1.61 m long; its front is
/// measured by Lobovský et al. (2014), up to when it reaches the far wall.

#include "solvers/fluids/tait.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/walls/free_slip.hpp"
#include "vnv/flows/dam_front.hpp"
#include "vnv/measures/roughness.hpp"
#include "vnv/methods/free_surface_methods.hpp"
#include "vnv/methods/setups.hpp"
#include "vnv/plots/along_ladders.hpp"
#include "vnv/plots/over_time.hpp"
#include "vnv/plots/snapshots.hpp"
#include "vnv/studies/run_time.hpp"

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

constexpr double l0 = 0.6, h0 = 0.6, tank_length = 1.61, tank_height = 1.2;  // m
constexpr double g = 9.8;                                                    // m/s²
constexpr double cell = 0.02;                                                // m
constexpr double output_interval = 0.01;                                     // s  holds whole numbers of steps
constexpr double mpm_step = 50 * us;                                         // as the paper
constexpr double sph_step = 25 * us;  // half the paper's, with which S4 diverges as it meets the wall

using Dam = Scene<Tait, Uniform>;
const Dam scene{
    .domain = {.box = {.high = {tank_length, tank_height}}},
    .fluid = {.density = 1000, .bulk_modulus = 0.36 * MPa},
    .filled = {.high = {l0, h0}},
    .walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(tank_length, free_slip())},
    .body_force = {{0, -g}},
};

const DamFront front{.column_length = l0,
                     .column_height = h0,
                     .tank_length = tank_length,
                     .tank_height = tank_height,
                     .density = scene.fluid.density,
                     .gravity = g,
                     .slab = cell};

/// Claims on the finest level of the report suite.
std::vector<Claim> front_claims(const std::string& level) {
  return {
      at_most(front.rms, 0.12,
              baseline("an independent prototype of MPM as printed differed by 0.09 from Lobovský et al. 2014"))
          .on(level),
      between(
          front.slope_error, -20, 20,
          baseline(
              "an independent prototype of MPM as printed differed by 16 % from the front speed of Lobovský et al. 2014, 1.34"))
          .on(level)};
}

const Quantity pressure_roughness{"pressure roughness over rho g h0", "%", Kind::error};

/// Quadratic B-splines, affine velocities and densities smoothed in the affine way, with the paper's cells. A4 has half
/// the step of the others: with theirs a particle that is alone in the jet at the far wall expands without bound.
Method smooth() {
  Method method = mpm_apic(scene, output_interval);
  method.levels = {{.name = "A1", .spacing = cell, .cell = cell, .acceptance = 0.5, .report = 0.5, .nightly = 0.5},
                   {.name = "A2", .spacing = cell / 2, .cell = cell, .acceptance = 0.5, .report = 0.5, .nightly = 0.5},
                   {.name = "A4", .spacing = cell / 4, .cell = cell, .time_step = 1e-4, .nightly = 0.5}};
  method.ladders = {{"points per cell, cells of 0.02 m", {"A1", "A2", "A4"}}};
  method.claims = front_claims("A2");
  method.claims.push_back(
      at_most(pressure_roughness, 2, baseline("2 % of the hydrostatic pressure at the bottom looks smooth")).on("A2"));
  return method;
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Dam break",
      .description =
          "A column of water 0.6 m square collapses under gravity in a tank 1.61 m long. The oracle is the front "
          "measured by Lobovský et al. (2014) for that column, with L = l / l0 and T = t sqrt(g h0) / l0; Martin & "
          "Moyce (1952) and Ritter's bound dL/dT = 2 are shown for comparison. The gate of the experiment takes time to rise "
          "and a jet leaves under it first, so the front is judged for T >= 1. It is the centre of the farthest vertical slice "
          "0.02 m wide that is half full.\n\nThe cells divide the tank evenly: 81 of 0.0199 m along its length, where the paper gives "
          "0.02 m.",
      .times = {0.32, 0.41, 0.46, 0.5},
      .watch = {.every = 0.01,
                .see = [](const Samples& s) { return front.look(s); },
                .quantities = DamFront::monitored},
      .measurements = {[](const Level& level, const Run& run) { return front.compare(level, run); },
                       roughness_of("pressure", pressure, "rho g h0", scene.fluid.density * g * h0, {0.32})},
      .claims = {between(front.mass_change, -1e-12, 1e-12, theory("particle masses are constant; rounding of the sum")),
                 between(front.lost, 0, 0, theory("water does not cross walls"))},
      .methods =
          {{
               .name = "mpm",
               .description =
                   "Material point method as printed by Sun et al., section 2.1, linear shape functions, cells of 0.02 m, "
                   "inviscid, free-slip walls imposed at nodes, time step 50 us.",
               .run = with_step(mpm_solver<mpm::PrescribedMotion, double, Dam>, scene, mpm_step),
               .levels =
                   {{.name = "M1", .spacing = cell, .cell = cell, .acceptance = 0.5, .report = 0.5, .nightly = 0.5},
                    {.name = "M2", .spacing = cell / 2, .cell = cell, .acceptance = 0.5, .report = 0.5, .nightly = 0.5},
                    {.name = "M3", .spacing = cell / 3, .cell = cell, .acceptance = 0.5, .report = 0.5, .nightly = 0.5},
                    {.name = "M4",
                     .spacing = cell / 4,
                     .cell = cell,
                     .acceptance = 0.5,
                     .report = 0.5,
                     .nightly = 0.5}},
               .ladders = {{"points per cell, cells of 0.02 m", {"M1", "M2", "M3", "M4"}}},
               .claims = front_claims("M4"),
               .tolerance = {0.02,
                             "a splash is chaotic: different rounding moves the front by a fraction of a spacing"},
           },
           {
               .name = "sph",
               .description =
                   "Smoothed particle hydrodynamics as printed by Sun et al., section 2.2, cubic spline with h = 1.2 "
                   "spacings, artificial viscosity 0.01 only, free-slip ghost particles, time step 25 us: with "
                   "the paper's 50 us pressure noise grows from 0.2 s on and a particle of S4 is pushed through the "
                   "wall at 0.385 s.",
               .run = with_step(sph_printed_solver<sph::Pressure, PredictorCorrector, Dam>, scene, sph_step),
               .levels = {{.name = "S1", .spacing = 0.02, .acceptance = 0.5, .report = 0.5, .nightly = 0.5},
                          {.name = "S2", .spacing = 0.01, .report = 0.5, .nightly = 0.5},
                          {.name = "S3", .spacing = 0.02 / 3, .report = 0.5, .nightly = 0.5},
                          {.name = "S4", .spacing = 0.005, .report = 0.5, .nightly = 0.5}},
               .ladders = {{"spacing at fixed h / spacing", {"S1", "S2", "S3", "S4"}}},
               .claims = front_claims("S4"),
               .tolerance = {0.02,
                             "a splash is chaotic: different rounding moves the front by a fraction of a spacing"},
               .relative_cost = 80,
           },
           smooth()},
      .plots = {snapshots({"snapshots",
                           "Particles at t = 0.32, 0.41 and 0.46 s, coloured by pressure",
                           "14400 particles (mpm_apic: 3600). Reproduces figure 11 of Sun et al.",
                           {"x [m]", 1, false, 0, 1.61},
                           {"y [m]", 1, false, 0, 0.7},
                           {"p [kPa]", 1e-3, false, 0, 6}},
                          {"M4", "S4", "A2"}, {0.32, 0.41, 0.46}),
                front.history(
                    {"front",
                     "Front position over time",
                     "L = l / l0 over T = t sqrt(g h0) / l0, (38) and (39). Reproduces figure 12(a) of Sun et al.",
                     {"time T", 1, false, 0, 1.6},
                     {"front L", 1, false, 1, 2.8}},
                    {"M1", "M2", "M3", "M4", "S1", "S2", "S3", "S4", "A2", "A4"}),
                along_ladders({"step_time",
                               "CPU time per step",
                               "One core. Reproduces figure 12(b) of Sun et al., who give no values.",
                               {.label = "particle number"},
                               {.label = "T_p [ms]", .scale = 1e3}},
                              {}, particle_number(), {{"", time_per_step()}}),
                along_ladders({"roughness",
                               "Roughness of the pressure",
                               "RMS deviation of each particle's pressure from a plane fitted to its neighbours', "
                               "at t = 0.32 s, before the water reaches the wall.",
                               {.label = "particle number", .logarithmic = true},
                               {.label = "roughness over rho g h0 [%]", .logarithmic = true}},
                              {}, particle_number(), {{"", error_of(pressure_roughness, 0.32)}}),
                error_against_run_time(
                    {.id = "work",
                     .title = "Work-precision diagram of the front",
                     .caption = "RMS of L over T in [1, 1.5], without time shift, over the CPU seconds from "
                                "rest to t = 0.5 s. No method models the gate of the experiment: a difference of "
                                "a few hundredths remains at any resolution.",
                     .quantity = front.rms,
                     .targets = {0.1, 0.08, 0.07},
                     .ranked_by = 0.1},
                    0.5),
                front.models()},
  };
}
