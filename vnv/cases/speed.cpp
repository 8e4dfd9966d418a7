/// Speed of the solvers: each timed alternately with a reference loop that does the same work, so that the machine and
/// its other load cancel.

#include "solvers/integrators/adams_bashforth.hpp"
#include "solvers/mpm/affine/affine.hpp"
#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "vnv/bench/flows.hpp"
#include "vnv/bench/mls_mpm.hpp"
#include "vnv/bench/plain_musl.hpp"
#include "vnv/bench/plain_sph.hpp"
#include "vnv/bench/race.hpp"
#include "vnv/flows/channel.hpp"
#include "vnv/record/record.hpp"
#include "vnv/run/soundness.hpp"

#include <thread>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::bench;

namespace {

const Author goal = baseline("goal set against the plain loop of vnv/bench");
const Author set_goal = baseline("goal set");

Level timed(std::string name, double spacing, double cell = not_a_number) {
  return {.name = std::move(name), .spacing = spacing, .cell = cell, .report = 1, .nightly = 1};
}

sph::Settings sph_settings(double spacing, double time_step, int threads = 1) {
  return {.spacing = spacing, .smoothing_length = 1.2 * spacing, .time_step = time_step, .threads = threads};
}

/// Right-hand sides in a step.
template <class Integrator>
constexpr int evaluations = 1;
template <>
constexpr int evaluations<PredictorCorrector> = 2;

Run race_mpm_in_channel(const Level& level, const Schedule&) {
  return race(mpm::solver<mpm::PrescribedMotion>(
                  bench::channel(), {.cell = level.cell, .spacing = level.spacing, .time_step = channel_step}),
              PlainMusl(plain(bench::channel()), level.cell, level.spacing, channel_step));
}

const Quantity watch_cost{"time of a monitor sample over that of the steps between two", "%", Kind::cost};

/// What the run loop takes to look at all particles, in turn with the steps that it lets pass between two looks.
Run time_the_watch(Simulation simulation) {
  const Soundness soundness(simulation.medium(), simulation.samples());
  const auto step = [&] {
    for (long k = 0; k < steps_between_looks; ++k) simulation.step();
  };
  const auto look = [&] { soundness.require(simulation.samples(), simulation.steps()); };
  const Times times = time_in_turn({look, step});
  Run run = run_of(simulation, times.of(1) / steps_between_looks);
  run.add(watch_cost, 100 * times.ratio(0, 1));
  run.add(spread, 100 * times.spread(0, 1));
  return run;
}
Run watch_mpm(const Level& level, const Schedule&) {
  return time_the_watch(mpm_solver<>(bench::channel(), level, channel_step));
}
Run watch_sph(const Level& level, const Schedule&) {
  return time_the_watch(sph_printed_solver<>(bench::channel(), level, channel_step));
}

auto dam_mpm(const Vec2& tank, const Level& level) {
  return mpm::solver<mpm::PrescribedMotion>(dam(tank),
                                            {.cell = level.cell, .spacing = level.spacing, .time_step = dam_mpm_step});
}

/// From 0.1 s on, when a third of the column's top has sunk.
Run race_mpm_in_dam(const Level& level, const Schedule&) {
  return race(dam_mpm(dam_tank, level), PlainMusl(plain(dam()), level.cell, level.spacing, dam_mpm_step), 2000);
}

Run race_mpm_in_single_precision(const Level& level, const Schedule&) {
  return race(mpm::solver<mpm::PrescribedMotion, float>(
                  bench::channel(), {.cell = level.cell, .spacing = level.spacing, .time_step = channel_step}),
              PlainMusl(plain(bench::channel()), level.cell, level.spacing, channel_step));
}

Run race_affine_mpm(const Level& level, const Schedule&) {
  return race(mpm::affine(bench::channel(), {.cell = level.cell, .spacing = level.spacing, .time_step = channel_step}),
              MlsMpm(plain(bench::channel()), level.cell, level.spacing, channel_step));
}

/// Terms as the plain loop has them: pressure and laminar viscosity.
template <class Integrator>
Run race_sph_in_channel(const Level& level, const Schedule&) {
  const double h = 1.2 * level.spacing;
  return race_with_rates(sph::printed<sph::CubicSpline, Integrator>(
                             bench::channel(), sph_settings(level.spacing, channel_step),
                             sph::momentum(sph::Pressure{}, sph::LaminarViscosity{.nu = 1e-6, .eta = 0.1 * h})),
                         PlainSph(plain(bench::channel()), level.spacing, channel_step), evaluations<Integrator>);
}

template <class Integrator>
Run race_sph_in_dam(const Level& level, const Schedule&) {
  const double h = 1.2 * level.spacing;
  return race_with_rates(
      sph::printed<sph::CubicSpline, Integrator>(
          dam(), sph_settings(level.spacing, dam_sph_step),
          sph::momentum(sph::Pressure{},
                        sph::ArtificialViscosity{.alpha = 0.01, .sound_speed = dam().fluid.sound_speed(), .h = h})),
      PlainSph(plain(dam()), level.spacing, dam_sph_step), evaluations<Integrator>);
}

// The column in tanks as many times as large as the paper's as the level's name says.
const Quantity empty_share{"empty fraction of the tank", "%"};
const Quantity slower{"time per step over that in the tank of the paper", "", Kind::cost};

Vec2 tank_of(const Level& level) {
  const double times = std::stod(level.name);
  return times <= 10 ? Vec2(times * dam_tank.x(), dam_tank.y()) : Vec2(times / 10 * dam_tank.x(), 10 * dam_tank.y());
}

Run compare_tanks(const Level& level, const Schedule&) {
  auto small = dam_mpm(dam_tank, level), large = dam_mpm(tank_of(level), level);
  const Times times = time_in_turn({[&] { large.step(); }, [&] { small.step(); }});
  Run run = run_of(large, times.of(0));
  run.add(slower, times.ratio(0, 1));
  run.add(spread, 100 * times.spread(0, 1));
  run.add(empty_share, 100 * (1 - dam().filled.size().prod() / tank_of(level).prod()));
  return run;
}

// One thread and two, by the clock on the wall. Two processors of a machine that does other things too, or that heat
// each other, give less than twice the work of one: two runs side by side, each on one thread, show how much.
const Quantity speed_up{"speed-up with two threads", "", Kind::cost, Better::larger};
const Quantity two_at_once{"throughput of two concurrent runs over that of one", "", Kind::cost, Better::larger};
const Quantity used{"speed-up with two threads over the throughput of two concurrent runs", "", Kind::cost,
                    Better::larger};

/// `make` makes a solver that uses so many threads.
template <class Make>
Run compare_threads(Make make) {
  auto one = make(1), other = make(1), two = make(2);
  const auto side_by_side = [&] {
    share_out(2, 2, [&](Eigen::Index which, Eigen::Index) { which == 0 ? one.step() : other.step(); });
  };
  const Times times = time_in_turn({[&] { one.step(); }, [&] { two.step(); }, side_by_side},
                                   {.rounds = 31, .seconds = 0.05, .clock = wall_time});
  Run run = run_of(two, times.of(1));
  run.add(speed_up, times.ratio(0, 1));
  run.add(two_at_once, 2 * times.ratio(0, 2));
  run.add(used, times.ratio(2, 1) / 2);
  run.add(spread, 100 * times.spread(0, 1));
  return run;
}

/// Eight channels of the paper, one after the other.
const auto long_channel = bench::channel(8 * channel_length);

Run compare_threads_of_mpm(const Level& level, const Schedule&) {
  return compare_threads([&](int threads) {
    return mpm::solver<mpm::PrescribedMotion>(
        long_channel, {.cell = level.cell, .spacing = level.spacing, .time_step = channel_step, .threads = threads});
  });
}

Run compare_threads_of_sph(const Level& level, const Schedule&) {
  const double h = 1.2 * level.spacing;
  return compare_threads([&](int threads) {
    return sph::printed<sph::CubicSpline>(
        long_channel, sph_settings(level.spacing, channel_step, threads),
        sph::momentum(sph::Pressure{}, sph::LaminarViscosity{.nu = 1e-6, .eta = 0.1 * h}));
  });
}

/// Of a machine with two processors.
std::vector<Method> with_threads() {
  const std::string words = "102400 particles, bitwise identical results for any number of threads.";
  return {{.name = "mpm_threads",
           .description = "Material point method, linear hats, in eight of the paper's channels: " + words,
           .run = compare_threads_of_mpm,
           .levels = {timed("M4", channel_cell / 4, channel_cell)},
           .claims = {at_least(used, 0.9, baseline("performance goal: 1.8 of 2"))}},
          {.name = "sph_threads",
           .description = "Smoothed particle hydrodynamics in eight of the paper's channels: " + words,
           .run = compare_threads_of_sph,
           .levels = {timed("S4", channel_cell / 4)},
           .claims = {at_least(used, 0.9, baseline("performance goal: 1.8 of 2"))}}};
}

/// Where a step's time goes, for each level that was raced.
void tabulate_sub_steps(const Results& results, Record& record) {
  Table table{"sub_steps",
              "Time of a step by sub-step",
              "Nanoseconds per particle-step, medians over alternating rounds.",
              {"method", "model", "whole step", "plain loop"},
              {}};
  table.columns.insert(table.columns.end(), names_of_sub_steps.begin(), names_of_sub_steps.end());
  for (const Run& run : results.runs) {
    if (std::isnan(run.value_of(loop_time))) continue;
    std::vector<Cell> row = {results.method.name, run.summary.level, run.value_of(solver_time),
                             run.value_of(loop_time)};
    for (std::size_t k = 0; k < names_of_sub_steps.size(); ++k) {
      const double time = run.value_of(time_of(SubStep(k)));
      row.push_back(std::isnan(time) ? 0 : time);
    }
    table.rows.push_back(std::move(row));
  }
  record.tables.push_back(std::move(table));
}

void draw_empty_background(const Results& results, Record& record) {
  Curve curve{"empty_background", results.method.name, Role::ours, {}, {}, false};
  for (const Run& run : results.runs)
    if (const double share = run.value_of(empty_share); !std::isnan(share)) {
      curve.x.push_back(share);
      curve.y.push_back(run.summary.cost.per_step());
    }
  if (curve.x.empty()) return;
  record.figures.push_back(
      {"empty_background",
       "CPU time per step against the empty fraction of the background grid",
       "The same column of 14400 particles in tanks 1, 10 and 100 times as large. Sun et al. give the empty background as "
       "a cost of MPM in the dam break.",
       {.label = "empty fraction of the grid [%]", .low = 80, .high = 100},
       {.label = "T_p [ms]", .scale = 1e3, .low = 0}});
  record.curves.push_back(std::move(curve));
}

const std::string plain_sph_words =
    " Pressure and laminar viscosity, timed in Poiseuille flow against a scalar loop over full neighbour lists. The rate "
    "is also reported scaled to a machine on which that loop's right-hand side takes 114 ns, where the other codes were measured.";
const std::string column_words =
    "The printed method in the dam break; the plain loop has its column without walls, and laminar viscosity where the "
    "solver has the artificial one.";

/// One core, each against its plain loop.
std::vector<Method> on_one_core() {
  return {
      {
          .name = "mpm",
          .description = channel::mpm_words + channel::moving_words +
                         " Timed in Poiseuille flow against the same method as plain loops over particles and nodes.",
          .run = race_mpm_in_channel,
          .levels = {timed("M1", channel_cell, channel_cell), timed("M2", channel_cell / 2, channel_cell),
                     timed("M3", channel_cell / 3, channel_cell), timed("M4", channel_cell / 4, channel_cell)},
          .claims = {at_least(faster, 2, goal).on("M1"), at_least(faster, 2, goal).on("M2"),
                     at_least(faster, 4, goal).on("M4"),
                     at_most(lap_cost, 1.05,
                             baseline("timing the sub-steps of one step in 16 must cost nothing; noise is 3 %"))
                         .on("M4")},
      },
      {
          .name = "mpm_watched",
          .description = "Cost of monitoring a run where steps are cheapest.",
          .run = watch_mpm,
          .levels = {timed("M1", channel_cell, channel_cell), timed("M4", channel_cell / 4, channel_cell)},
          .claims = {at_most(watch_cost, 1, set_goal)},
      },
      {
          .name = "sph_watched",
          .description = "The same for smoothed particle hydrodynamics.",
          .run = watch_sph,
          .levels = {timed("S1", channel_cell)},
          .claims = {at_most(watch_cost, 1, set_goal)},
      },
      {
          .name = "mpm_single",
          .description = "The same with particles in single precision; the plain loop is in double precision.",
          .run = race_mpm_in_single_precision,
          .levels = {timed("M4", channel_cell / 4, channel_cell)},
          .claims = {at_least(faster, 4, goal)},
      },
      {
          .name = "mpm_affine",
          .description =
              "Affine material point method on quadratic B-splines, timed in Poiseuille flow against the 88-line "
              "algorithm of Hu et al. (2018).",
          .run = race_affine_mpm,
          .levels = {timed("M2", channel_cell / 2, channel_cell), timed("M4", channel_cell / 4, channel_cell)},
          .claims = {at_least(faster, 2.5, goal).on("M4")},
      },
      {
          .name = "mpm_dam_break",
          .description = "The same in the dam break, from 0.1 s on. The reference loop stores the full stress tensor.",
          .run = race_mpm_in_dam,
          .levels = {timed("M4", dam_cell / 4, dam_cell)},
          .claims = {at_least(faster, 2.5, goal)},
      },
      {
          .name = "mpm_empty_background",
          .description = "The column of the dam break in tanks 1, 10 and 100 times as large as the paper's.",
          .run = compare_tanks,
          .levels = {timed("1", dam_cell / 4, dam_cell), timed("10", dam_cell / 4, dam_cell),
                     timed("100", dam_cell / 4, dam_cell)},
          .claims = {between(slower, 0.9, 1.1, set_goal)},
      },
      {
          .name = "sph",
          .description = channel::sph_printed_words + plain_sph_words,
          .run = race_sph_in_channel<PredictorCorrector>,
          .levels = {timed("S2", channel_cell / 2)},
          .claims = {at_least(faster_rates, 2.5, goal), at_least(scaled_rate, 7, goal)},
      },
      {
          .name = "sph_dam_break",
          .description = column_words,
          .run = race_sph_in_dam<PredictorCorrector>,
          .levels = {timed("S4", dam_cell / 4)},
          .claims = {at_least(faster_rates, 2.5, goal)},
      },
      {
          .name = "sph_one_evaluation",
          .description = "The same by Adams-Bashforth, with one right-hand side per step.",
          .run = race_sph_in_channel<AdamsBashforth>,
          .levels = {timed("S2", channel_cell / 2)},
          .claims = {at_least(faster_rates, 2.5, goal), at_least(scaled_rate, 13, goal)},
      },
      {
          .name = "sph_one_evaluation_dam_break",
          .description = column_words + " With one right-hand side a step.",
          .run = race_sph_in_dam<AdamsBashforth>,
          .levels = {timed("S4", dam_cell / 4)},
          .claims = {at_least(faster_rates, 2.5, goal), at_least(scaled_rate, 8, goal)},
      }};
}

std::vector<Method> on_this_machine() {
  std::vector<Method> all = on_one_core();
  if (std::thread::hardware_concurrency() >= 2)
    for (Method& method : with_threads()) all.push_back(std::move(method));
  return all;
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Speed against reference loops",
      .description =
          "Steps of a solver are timed alternately with those of a textbook loop over the same particles, kept in "
          "vnv/bench: medians of CPU time over rounds, one core. Ratios depend less on the machine than times do.",
      .times = {1},
      .measurements = {},
      .methods = on_this_machine(),
      .plots = {tabulate_sub_steps, draw_empty_background},
      .timed = true,
  };
}
