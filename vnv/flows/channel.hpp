#pragma once
/// What the two channel flows of Sun et al. share: geometry and water of table 1, models of table 2, figures and
/// tables.

#include "solvers/fluids/newtonian.hpp"
#include "vnv/case.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/measures/norms_of.hpp"
#include "vnv/measures/per_particle.hpp"
#include "vnv/measures/row_means.hpp"
#include "vnv/methods/methods.hpp"
#include "vnv/methods/setups.hpp"
#include "vnv/plots/along_ladders.hpp"
#include "vnv/plots/over_time.hpp"
#include "vnv/plots/profiles.hpp"

namespace touchstone::vnv::channel {

inline constexpr double L = 0.5 * mm, H = 1 * mm;  // table 1
inline constexpr Newtonian water{{.density = 1000, .bulk_modulus = 143}, 1e-3};
inline constexpr double dt = 5 * us;

/// The box between the plates, periodic along x and full of water.
inline const Box gap{.high = {L, H}};

// Ladders, by what they refine.
inline const std::string points_per_cell = "points per cell, cells of 0.025 mm";
inline const std::string grid = "grid at 4 points per cell";
inline const std::string spacing_ladder = "spacing at fixed h / spacing";

// Quantities that every method is judged by.
inline const Quantity l2_rows{"L2 v_x, row means", "%", Kind::norm}, linf_rows{"Linf v_x, row means", "%", Kind::norm};
inline const Quantity l2{"L2 v_x, per particle", "%", Kind::norm}, linf{"Linf v_x, per particle", "%", Kind::norm};

/// Rows as the paper averages them, one per particle row of the start.
inline Measure by_rows(const Level& level) { return row_means(velocity_x, level.spacing); }
inline Measure by_particles(const Level&) { return per_particle(velocity_x); }

/// M1 to M4 of table 2, and 10, 20, 40, 80 cells across at 4 per cell; M2 belongs to both. How far a report runs the
/// finest and a night M2 [s].
inline std::vector<Level> mpm_levels(double finest_report, double second_nightly) {
  const double cell = 0.025 * mm;
  return {
      {.name = "M1", .spacing = cell, .cell = cell, .acceptance = 1, .report = 1, .nightly = 1},
      {.name = "G10", .spacing = H / 20, .cell = H / 10, .acceptance = 1, .report = 1, .nightly = 1},
      {.name = "G20", .spacing = H / 40, .cell = H / 20, .acceptance = 1, .report = 1, .nightly = 1},
      {.name = "M2", .spacing = cell / 2, .cell = cell, .acceptance = 1, .report = 1, .nightly = second_nightly},
      {.name = "M3", .spacing = cell / 3, .cell = cell, .report = 1, .nightly = 1},
      {.name = "M4", .spacing = cell / 4, .cell = cell, .report = 1, .nightly = 1},
      {.name = "G80", .spacing = H / 160, .cell = H / 80, .report = finest_report, .nightly = 1},
  };
}
inline std::vector<Ladder> mpm_ladders() {
  return {{points_per_cell, {"M1", "M2", "M3", "M4"}}, {grid, {"G10", "G20", "M2", "G80"}}};
}
inline std::vector<Ladder> sph_ladders(const std::vector<std::string>& levels) { return {{spacing_ladder, levels}}; }

// Runs of the solvers of vnv/methods/setups.hpp with a fixed step [s].

template <class WallTreatment, class Number = double, class SceneOfChannel>
auto mpm_with(const SceneOfChannel& scene, double time_step = dt) {
  return with_step(mpm_solver<WallTreatment, Number, SceneOfChannel>, scene, time_step);
}
template <class SceneOfChannel>
auto mpm_affine(const SceneOfChannel& scene, double time_step = dt) {
  return with_step(mpm_affine_solver<SceneOfChannel>, scene, time_step);
}
template <class PressureTerm = sph::Pressure, class Integrator = PredictorCorrector, class SceneOfChannel>
auto sph_as_printed(const SceneOfChannel& scene, double time_step = dt) {
  return with_step(sph_printed_solver<PressureTerm, Integrator, SceneOfChannel>, scene, time_step);
}
template <class Integrator = KickDriftKick, class Real = double, class SceneOfChannel>
auto sph_with_transport_velocity(const SceneOfChannel& scene, double time_step = 2 * dt) {
  return with_step(sph_regularised_solver<Integrator, Real, SceneOfChannel>, scene, time_step);
}

/// The methods in words.
inline const std::string mpm_words =
    "Material point method as printed by Sun et al., section 2.1: linear shape functions, lumped mass, explicit Euler, FLIP, remapped "
    "momentum (MUSL). The paper leaves open which acceleration a wall node transmits to its particles. ";
inline const std::string moving_words = "Here the node moves with the wall: v = V, a = dV/dt. Expected order 2.";
inline const std::string reset_words =
    "Here its velocity is reset, a = (V - v) / dt, which is transmitted to the particles. Expected order 1 in Linf; in L2, where only "
    "the cells at the wall are wrong, 1.5.";
inline const std::string affine_words =
    "Material point method with quadratic B-splines and affine particle velocities (APIC, Jiang et al. 2015), the stress "
    "given to the nodes as in MLS-MPM (Hu et al. 2018), explicit Euler, walls by mirrored cells. Particles take their "
    "velocity from the nodes, which adds a little dissipation in each step: the largest stable step is the most accurate.";
inline const std::string float_words = " Particles in single precision.";
inline const std::string sph_printed_words =
    "Smoothed particle hydrodynamics as printed by Sun et al., section 2.2: cubic spline with h = 1.2 spacings, continuity "
    "density, laminar viscosity (26), artificial viscosity (27), density reinitialised every 30 steps, ghost and repulsive "
    "particles, predictor-corrector. The paper leaves open the force of the repulsive particles; here it acts only on fluid particles "
    "that are closer to the wall than initially. ";
inline const std::string conservative_words =
    "The pressure term is the conservative one, with a plus between the pressures where (24) and (28) print a minus: any mean "
    "pressure then makes the lattice of particles elastic, and the flow is wrong until its rows have slipped; "
    "refining does not help.";
inline const std::string difference_words =
    "The minus that (24) and (28) print between the pressures is kept, with the leading sign corrected: a difference of "
    "pressures, which does not conserve momentum pair by pair but vanishes for uniform pressure.";
inline const std::string sph_regularised_words =
    "Smoothed particle hydrodynamics with a transport velocity (Adami, Hu & Adams 2013), quintic spline with "
    "h = 1 spacing, continuity density, pressure differences, viscosity of Morris, Fox & Zhu (1997), wall velocities mirrored "
    "(Adami, Hu & Adams 2012), kick-drift-kick with twice the paper's time step.";
inline const std::string one_evaluation_words =
    " Here with Adams-Bashforth steps of third order, one evaluation of the right-hand side per step.";

/// How much larger an error is at 10 s than at 1 s, for runs that go so far.
inline const Quantity growth{"L2 v_x, per particle, at 10 s over that at 1 s", "", Kind::value, Better::smaller};
inline std::vector<Value> growth_of(const Level& level, const Run& run, const Truth& truth) {
  const Samples *early = run.at(1), *late = run.at(10);
  if (!early || !late) return {};
  const auto error = [&](const Samples& samples) {
    const Profile profile = per_particle(velocity_x)(samples);
    std::vector<double> exact;
    for (const double y : profile.at) exact.push_back(truth(y, samples.time));
    return relative_l2(profile.value, exact, profile.weight);
  };
  return {{level.name, level.spacing, late->time, growth, error(*late) / error(*early)}};
}

/// The limits of table 3 or 4 on each level, for the L2 norm at 1 s.
inline std::vector<Claim> at_most_the_papers(const std::string& table, const std::vector<double>& limits, char series) {
  std::vector<Claim> claims;
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const std::string level = series + std::to_string(k + 1);
    claims.push_back(
        at_most(l2_rows, limits[k], literature("Sun et al., table " + table + ", " + level)).on(level).at(1));
  }
  return claims;
}

/// At most so small a share of what a table of the paper has at 1 s.
inline Claim a_share_of_the_papers(int share, double error, const std::string& where) {
  return at_most(l2_rows, error / share, literature(fmt::format("Sun et al., {}, over {}", where, share))).at(1);
}

inline std::vector<Claim> operator+(std::vector<Claim> claims, const Claim& more) {
  claims.push_back(more);
  return claims;
}

/// S1 to S4 of table 2, as the suites run the printed method and the regularised one. How far a report runs S3 of the
/// printed one [s].
inline std::vector<Level> printed_levels(double third_report) {
  return {{.name = "S1", .spacing = H / 40, .acceptance = 0.2, .report = 1, .nightly = 1},
          {.name = "S2", .spacing = H / 80, .acceptance = 0.05, .report = 1, .nightly = 1},
          {.name = "S3", .spacing = H / 120, .report = third_report, .nightly = 1},
          {.name = "S4", .spacing = H / 160, .nightly = 1}};
}
inline std::vector<Level> difference_levels() {
  return {{.name = "S1", .spacing = H / 40, .acceptance = 0.2, .report = 1, .nightly = 1},
          {.name = "S2", .spacing = H / 80, .nightly = 0.2}};
}
inline std::vector<Level> regularised_levels() {
  return {{.name = "S1", .spacing = H / 40, .acceptance = 0.2, .report = 1, .nightly = 10},
          {.name = "S2", .spacing = H / 80, .acceptance = 0.05, .report = 0.2, .nightly = 0.2},
          {.name = "S3", .spacing = H / 120, .nightly = 0.2}};
}

/// The methods of second order at times that 0.05 s divides, on ladders that hold two particle numbers of the paper:
/// 800 and 3200.
template <class SceneOfChannel>
std::vector<Method> second_order_methods(const SceneOfChannel& scene, const std::vector<Claim>& of_mpm,
                                         const std::vector<Claim>& of_sph) {
  const auto named = [](std::vector<Level> levels, char series) {
    for (Level& level : levels)
      if (level.name == "40 across" || level.name == "80 across")
        level.name = series + std::string(level.name == "40 across" ? "1" : "2");
    return levels;
  };
  return {
      with_ladder(
          named(levels_across(H, {{20, 0.1, 0, 0.1}, {28, 0.1, 0, 0.1}, {40, 0, 0, 1}, {56, 0, 0, 0.1}, {80, 0, 0, 1}}),
                'M'),
          mpm_least_squares(scene, 0.05), of_mpm),
      with_ladder(named(levels_across(
                            H, {{14, 0.1, 0, 0.1}, {20, 0.1, 0, 0.1}, {28, 0, 0, 0.1}, {40, 0, 0, 1}, {56, 0, 0, 0.1}}),
                        'S'),
                  sph_second_order(scene, 0.05), of_sph)};
}

/// The rows of tables 3 and 4 of Sun et al. for one flow and one of its methods, "MPM" or "SPH".
DataTable published(const std::string& flow, const std::string& method);

/// Figures 6 or 9, errors and cost over the particle number, the errors over spacing and CPU time; table 3 or 4.
std::vector<Plot> figures(const std::string& flow, const std::string& errors_figure, const std::string& table);

}  // namespace touchstone::vnv::channel
