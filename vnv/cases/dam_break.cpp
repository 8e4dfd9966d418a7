/// Dam break [Sun et al., section 3.3]. A column of water 0.6 m square collapses in a tank 1.61 m long; its front is
/// measured by Lobovský et al. (2014), up to when it reaches the far wall.

#include "vnv/flows/dam_break.hpp"
#include "vnv/measures/plots/along_ladders.hpp"
#include "vnv/measures/plots/over_time.hpp"
#include "vnv/measures/plots/snapshots.hpp"
#include "vnv/measures/roughness.hpp"
#include "vnv/methods/free_surface_methods.hpp"
#include "vnv/methods/setups.hpp"
#include "vnv/studies/run_time.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::dam_break;

namespace {

constexpr double output_interval = 0.01;  // s  holds whole numbers of steps
constexpr double mpm_step = 50 * us;      // as the paper
constexpr double sph_step = 25 * us;      // half the paper's, with which S4 diverges as it meets the wall

using Dam = Scene<Tait, Uniform>;
const Dam scene = collapse(column, tank);

/// Claims on the finest level of the report suite.
std::vector<Claim> front_claims(const std::string& level) {
  return {
      near_the_experiment.on(level),
      between(
          front.slope_error, -20, 20,
          baseline(
              "an independent prototype of MPM as printed differed by 16 % from the front speed of Lobovský et al. 2014, 1.34"))
          .on(level)};
}

const Quantity pressure_roughness{"pressure roughness over rho g h0", "%", Kind::error};

/// A level that all suites run to the end.
Level model(std::string name, double spacing, double cell_size = not_a_number) {
  return {
      .name = std::move(name), .spacing = spacing, .cell = cell_size, .acceptance = 0.5, .report = 0.5, .nightly = 0.5};
}

const Tolerance chaotic{0.02, "a splash is chaotic: different rounding moves the front by a fraction of a spacing"};
const std::string ladder_in_cells = "points per cell, cells of 0.02 m";

Method printed_mpm() {
  return {.name = "mpm",
          .family = Family::mpm,
          .description =
              "Material point method as printed by Sun et al., section 2.1, linear shape functions, cells of 0.02 m, "
              "inviscid, free-slip walls imposed at nodes, time step 50 us.",
          .run = with_step(mpm_solver<mpm::PrescribedMotion, double, Dam>, scene, mpm_step),
          .levels = {model("M1", cell, cell), model("M2", cell / 2, cell), model("M3", cell / 3, cell),
                     model("M4", cell / 4, cell)},
          .ladders = {{ladder_in_cells, {"M1", "M2", "M3", "M4"}}},
          .claims = front_claims("M4"),
          .tolerance = chaotic};
}

Method printed_sph() {
  return {.name = "sph",
          .family = Family::sph,
          .description =
              "Smoothed particle hydrodynamics as printed by Sun et al., section 2.2, cubic spline with h = 1.2 "
              "spacings, artificial viscosity 0.01 only, free-slip ghost particles, time step 25 us: with "
              "the paper's 50 us pressure noise grows from 0.2 s on and a particle of S4 is pushed through the "
              "wall at 0.385 s.",
          .run = with_step(sph_printed_solver<sph::Pressure, PredictorCorrector, Dam>, scene, sph_step),
          .levels = {model("S1", 0.02),
                     {.name = "S2", .spacing = 0.01, .report = 0.5, .nightly = 0.5},
                     {.name = "S3", .spacing = 0.02 / 3, .report = 0.5, .nightly = 0.5},
                     {.name = "S4", .spacing = 0.005, .report = 0.5, .nightly = 0.5}},
          .ladders = {{"spacing at fixed h / spacing", {"S1", "S2", "S3", "S4"}}},
          .claims = front_claims("S4"),
          .tolerance = chaotic,
          .relative_cost = 80};
}

/// Quadratic B-splines, affine velocities and densities smoothed in the affine way, with the paper's cells. A4 has half
/// the step of the others: with theirs a particle that is alone in the jet at the far wall expands without bound.
Method smooth() {
  Method method = mpm_apic(scene, output_interval);
  method.levels = {model("A1", cell, cell),
                   model("A2", cell / 2, cell),
                   {.name = "A4", .spacing = cell / 4, .cell = cell, .time_step = 1e-4, .nightly = 0.5}};
  method.ladders = {{ladder_in_cells, {"A1", "A2", "A4"}}};
  method.claims = front_claims("A2");
  method.claims.push_back(
      at_most(pressure_roughness, 2, baseline("2 % of the hydrostatic pressure at the bottom looks smooth")).on("A2"));
  return method;
}

}  // namespace

Case vnv::the_case() {
  const Flow flow = flow_named("dam_break");
  Case declared = front_followed(
      flow.title(),
      flow.judged.description +
          " Here the front measured by Lobovský et al. (2014) judges. The gate of the experiment takes time to rise and a "
          "jet leaves under it first, so the front is judged for T >= 1. It is the centre of the farthest "
          "vertical slice 0.02 m wide that is half full.\n\nThe cells divide the tank evenly: 81 of 0.0199 m along its "
      "length, where the paper gives 0.02 m.");
  declared.times = flow.judged.times;
  declared.measurements.push_back(
      roughness_of("pressure", pressure, "rho g h0", water.density * g * column.y(), {0.32}));
  declared.claims = {
      between(front.mass_change, -1e-12, 1e-12, theory("particle masses are constant; rounding of the sum")),
      between(front.lost, 0, 0, theory("water does not cross walls"))};
  declared.methods = {printed_mpm(), printed_sph(), smooth()};
  declared.priced_as = "elliptic_drop";
  declared.plots = {
      snapshots({"snapshots",
                 "Particles at t = 0.32, 0.41 and 0.46 s, coloured by pressure",
                 "14400 particles (mpm_apic: 3600). Reproduces figure 11 of Sun et al.",
                 {"x [m]", 1, false, 0, 1.61},
                 {"y [m]", 1, false, 0, 0.7},
                 {"p [kPa]", 1e-3, false, 0, 6}},
                {"M4", "S4", "A2"}, {0.32, 0.41, 0.46}),
      front.history({"front",
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
      error_against_run_time(work, {0.5}),
      front.models()};
  return declared;
}
