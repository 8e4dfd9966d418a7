/// Speed of the solvers: each timed alternately with a reference loop that does the same work, so that the machine and
/// its other load cancel.

#include "solvers/integrators/adams_bashforth.hpp"
#include "solvers/mpm/lanes/in_lanes.hpp"
#include "solvers/mpm/least_squares/least_squares.hpp"
#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "solvers/sph/free_surface/diffusion/antuono.hpp"
#include "solvers/sph/free_surface/free_surface.hpp"
#include "solvers/sph/free_surface/gradients/bonet_lok.hpp"
#include "solvers/sph/free_surface/shifting/tangential.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/second_order/second_order.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/bonet_lok_pressure.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/transport_velocity/transport_velocity.hpp"
#include "vnv/bench/scenes.hpp"
#include "vnv/bench/mls_mpm.hpp"
#include "vnv/bench/plain_musl.hpp"
#include "vnv/bench/plain_sph.hpp"
#include "vnv/bench/race.hpp"
#include "vnv/flows/channels/channel.hpp"
#include "vnv/flows/manufactured.hpp"
#include "vnv/record/record.hpp"
#include "vnv/run/state_check.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <thread>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::bench;

namespace {

const Author goal = baseline("goal set against the plain loop of vnv/bench");
const Author set_goal = baseline("goal set");
const Author kept = baseline("nine tenths of the least that was measured on a busy machine");

const Author most_measured =
    baseline("a tenth above the most that was measured; what bounds it: solvers/sph/README.md");

Level timed(std::string name, double spacing, double cell = not_a_number) {
  return {.name = std::move(name), .spacing = spacing, .cell = cell, .report = 1, .nightly = 1};
}

mpm::Settings mpm_settings(const Level& level, double time_step, int threads = 1) {
  return {.cell = level.cell, .spacing = level.spacing, .time_step = time_step, .threads = threads};
}
sph::Settings sph_settings(const Level& level, double time_step, int threads = 1) {
  return {
      .spacing = level.spacing, .smoothing_length = 1.2 * level.spacing, .time_step = time_step, .threads = threads};
}

// Viscous terms, by the smoothing length [m].
constexpr auto laminar = [](double h) { return sph::LaminarViscosity{.nu = 1e-6, .eta = 0.1 * h}; };
const auto artificial = [](double h) {
  return sph::ArtificialViscosity{.alpha = 0.01, .sound_speed = dam().fluid.sound_speed(), .h = h};
};

/// Right-hand sides in a step.
template <class Integrator>
constexpr int evaluations = 1;
template <>
constexpr int evaluations<PredictorCorrector> = 2;

/// Printed MPM against the plain loop.
template <class Number = double, class AnyScene>
auto race_mpm(const AnyScene& scene, double time_step) {
  return [=](const Level& level, const Schedule&) {
    return race(mpm::printed<mpm::PrescribedMotion, Number>(scene, mpm_settings(level, time_step)),
                PlainMusl(plain(scene), level.cell, level.spacing, time_step));
  };
}

Run race_affine_mpm(const Level& level, const Schedule&) {
  return race(mpm::in_lanes<mpm::QuadraticBSpline, mpm::MlsApic>(bench::channel(), mpm_settings(level, channel_step)),
              MlsMpm(plain(bench::channel()), level.cell, level.spacing, channel_step));
}

/// A solver that goes back to where it was after `lead` steps whenever it has gone `stretch` steps from there. A race
/// has as many steps as the machine and its load allow, and some time after the impact a dam break leaves its tank.
template <class Solver>
class Repeated {
 public:
  Repeated(Solver solver, long lead, long stretch) : now_(std::move(solver)), lead_(lead), stretch_(stretch) {}

  void step(const Laps& lap = no_laps) {
    if (now_->steps() == lead_) start_.emplace(*now_);
    if (now_->steps() == lead_ + stretch_) now_.emplace(*start_);
    now_->step(lap);
  }
  Index particles() const { return now_->particles(); }
  Index boundary_particles() const { return now_->boundary_particles(); }
  long steps() const { return now_->steps(); }
  double time() const { return now_->time(); }
  double time_step() const { return now_->time_step(); }

 private:
  std::optional<Solver> now_, start_;
  long lead_, stretch_;
};

/// The same in the dam break from 0.1 to 0.4 s.
Run race_mpm_in_dam(const Level& level, const Schedule&) {
  constexpr long lead = 2000, stretch = 6000;
  return race(Repeated(mpm::printed<mpm::PrescribedMotion>(dam(), mpm_settings(level, dam_mpm_step)), lead, stretch),
              PlainMusl(plain(dam()), level.cell, level.spacing, dam_mpm_step), lead);
}

/// MPM with quadratic B-splines in the dam break from 0.1 to 0.4 s, against the 88-line algorithm.
template <class Transfer>
Run race_splines(const Level& level, const Schedule&) {
  constexpr double time_step = 2 * dam_mpm_step;
  constexpr long lead = 1000, stretch = 3000;
  return race(
      Repeated(mpm::in_lanes<mpm::BSpline<2>, Transfer, mpm::AffineDensity>(dam(), mpm_settings(level, time_step)),
               lead, stretch),
      MlsMpm(plain(dam()), level.cell, level.spacing, time_step), lead);
}

/// Printed SPH with pressure and one viscous term against the plain loop, which has laminar viscosity.
template <class Integrator, class AnyScene, class Viscosity>
auto race_sph(const AnyScene& scene, double time_step, Viscosity viscosity) {
  return [=](const Level& level, const Schedule&) {
    return race_with_rates(
        sph::printed<sph::CubicSpline, Integrator>(scene, sph_settings(level, time_step),
                                                   sph::momentum(sph::Pressure{}, viscosity(1.2 * level.spacing))),
        PlainSph(plain(scene), level.spacing, time_step), evaluations<Integrator>);
  };
}

/// Printed SPH with the viscous term of the flow.
template <class AnyScene>
auto printed_sph(const AnyScene& scene, const Level& level, double time_step) {
  const double h = 1.2 * level.spacing;
  const sph::Settings settings = sph_settings(level, time_step);
  if constexpr (Viscous<decltype(scene.fluid)>)
    return sph::printed<sph::CubicSpline>(
        scene, settings,
        sph::momentum(sph::Pressure{}, sph::LaminarViscosity{.nu = scene.fluid.kinematic_viscosity(), .eta = 0.1 * h}));
  else
    return sph::printed<sph::CubicSpline>(scene, settings, sph::momentum(sph::Pressure{}, artificial(h)));
}

/// SPH for free surfaces, of the parts that `parts`(h, spacing) makes, in the dam break.
template <class MakeParts>
auto race_free_surface(const MakeParts& parts) {
  return [=](const Level& level, const Schedule&) {
    const double h = 2 * level.spacing, time_step = 4 * dam_sph_step;
    return race_with_printed(sph::free_surface<sph::WendlandC2>(
                                 dam(), {.spacing = level.spacing, .smoothing_length = h, .time_step = time_step},
                                 sph::momentum(artificial(h)), parts(h, level.spacing)),
                             printed_sph(dam(), level, time_step), 100);
  };
}
sph::Antuono diffusion_in_dam(double h) { return {.delta = 0.1, .sound_speed = dam().fluid.sound_speed(), .h = h}; }

/// A square of vortices, without the force of the manufactured flow: its evaluation is not the method's.
const Scene<Newtonian>& vortices() {
  static const Scene<Newtonian> scene = [] {
    Flow flow = flow_named("manufactured");
    flow.drive = {};
    return scene_of<>(flow);
  }();
  return scene;
}
double step_in_vortices(const Level& level) { return 0.2 * level.spacing / vortices().fluid.sound_speed(); }

/// MPM by least squares in the manufactured flow without its force, whose evaluation is not the method's, against as
/// many particles of the plain loop in a square channel.
Run race_least_squares(const Level& level, const Schedule&) {
  const double time_step = 0.3 * level.cell / vortices().fluid.sound_speed(), side = channel_cell / level.cell;
  return race(mpm::least_squares(vortices(), mpm_settings(level, time_step)),
              PlainMusl(plain(bench::channel(side, side)), channel_cell, channel_cell / 2, channel_step), 100);
}

template <class AnyScene>
Run race_second_order(const AnyScene& scene, const Level& level, double time_step) {
  return race_with_printed(
      sph::second_order<sph::WendlandC2>(
          scene, {.spacing = level.spacing, .smoothing_length = 1.3 * level.spacing, .time_step = time_step}),
      printed_sph(scene, level, time_step), 100);
}
template <class AnyScene>
Run race_transport_velocity(const AnyScene& scene, const Level& level, double time_step) {
  return race_with_printed(
      sph::transport_velocity<sph::QuinticSpline>(
          scene, {.spacing = level.spacing, .smoothing_length = level.spacing, .time_step = time_step},
          sph::momentum(sph::Pressure{}, sph::MorrisViscosity{.mu = scene.fluid.viscosity})),
      printed_sph(scene, level, time_step), 100);
}

const Quantity monitor_cost{"time of a monitor sample over that of the steps between two", "%", Kind::cost};

/// What the run loop takes to evaluate all particles, in turn with the steps that it lets pass between two samples.
auto time_the_monitor(Simulation (*solver)(const Scene<Newtonian, Uniform>&, const Level&, double)) {
  return [=](const Level& level, const Schedule&) {
    Simulation simulation = solver(bench::channel(), level, channel_step);
    const StateCheck state_check(simulation.medium(), simulation.samples());
    const auto step = [&] {
      for (long k = 0; k < steps_between_checks; ++k) simulation.step();
    };
    const auto sample = [&] { state_check.require(simulation.samples(), simulation.steps()); };
    const Times times = time_in_turn({sample, step});
    Run run = run_of(simulation, times.of(1) / steps_between_checks);
    run.add(monitor_cost, 100 * times.ratio(0, 1));
    run.add(spread, 100 * times.spread(0, 1));
    return run;
  };
}

/// Tries, sorted by that quantity. Solvers that are made anew lie elsewhere in memory, which alone may change a
/// ratio of times by more than a tenth, for as long as they live.
std::vector<Run> tries(std::size_t number, const Quantity& quantity, const std::function<Run()>& attempt) {
  std::vector<Run> runs(number);
  std::ranges::generate(runs, attempt);
  std::ranges::sort(runs, {}, [&](const Run& run) { return run.value_of(quantity); });
  return runs;
}
Run median_of_tries(const Quantity& quantity, const std::function<Run()>& attempt) {
  return tries(3, quantity, attempt)[1];
}

// The column in tanks as many times as large as the paper's as the level's name says.
const Quantity empty_fraction{"empty fraction of the tank", "%"};
const Quantity slower{"time per step over that in the tank of the paper", "", Kind::cost};

Vec2 tank_of(const Level& level) {
  const double times = std::stod(level.name);
  return times <= 10 ? Vec2(times * dam_tank.x(), dam_tank.y()) : Vec2(times / 10 * dam_tank.x(), 10 * dam_tank.y());
}

Run compare_tanks(const Level& level) {
  const auto in_tank = [&](const Vec2& tank) {
    return mpm::printed<mpm::PrescribedMotion>(dam(tank), mpm_settings(level, dam_mpm_step));
  };
  auto small = in_tank(dam_tank), large = in_tank(tank_of(level));
  const Times times = time_in_turn({[&] { large.step(); }, [&] { small.step(); }});
  Run run = run_of(large, times.of(0));
  run.add(slower, times.ratio(0, 1));
  run.add(spread, 100 * times.spread(0, 1));
  run.add(empty_fraction, 100 * (1 - dam().filled.size().prod() / tank_of(level).prod()));
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

/// The best of five: where memory lies badly it is not the threads that cost, and where something else takes a
/// processor for a while two threads wait for each other, but two runs do not.
template <class Make>
Run best_with_threads(Make make) {
  return tries(5, used, [&] { return compare_threads(make); }).back();
}

/// In eight channels of the paper, one after the other, on a machine with two processors.
std::vector<Method> with_threads() {
  const auto long_channel = bench::channel(8 * channel_length);
  const std::string words = "102400 particles, bitwise identical results for any number of threads.";
  const auto of_mpm = [=](const Level& level, const Schedule&) {
    return best_with_threads([&](int threads) {
      return mpm::printed<mpm::PrescribedMotion>(long_channel, mpm_settings(level, channel_step, threads));
    });
  };
  const auto of_sph = [=](const Level& level, const Schedule&) {
    return best_with_threads([&](int threads) {
      return sph::printed<sph::CubicSpline>(long_channel, sph_settings(level, channel_step, threads),
                                            sph::momentum(sph::Pressure{}, laminar(1.2 * level.spacing)));
    });
  };
  return {{.name = "mpm_threads",
           .description = "Material point method, linear hats, in eight lengths of the paper's channel: " + words,
           .run = of_mpm,
           .levels = {timed("M4", channel_cell / 4, channel_cell)},
           .claims = {at_least(used, 0.8,
                               baseline("0.86 where two threads are started in 4.4 us, five times a step: "
                                        "reports/findings.md"))}},
          {.name = "sph_threads",
           .description = "Smoothed particle hydrodynamics in eight lengths of the paper's channel: " + words,
           .run = of_sph,
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
    if (const double fraction = run.value_of(empty_fraction); !std::isnan(fraction)) {
      curve.x.push_back(fraction);
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
    " With pressure and laminar viscosity only, timed in Poiseuille flow against a scalar loop over full neighbour "
    "lists. The rate is also scaled to the machine on which the other codes were measured, where the right-hand side "
    "of that loop takes 114 ns.";
const std::string column_words =
    "Smoothed particle hydrodynamics as printed, in the dam break; the plain loop has the same column but no walls, "
    "and laminar instead of artificial viscosity.";

/// Of four and of sixteen particles per cell; `least` are the speed-ups that they must keep.
Method race_of_splines(const std::string& name, const std::string& transfer, Run (*run)(const Level&, const Schedule&),
                       double least_of_4, double least_of_16) {
  return {
      .name = name,
      .description = fmt::format(
          "Material point method on quadratic B-splines, {}, affine densities, in the dam break from 0.1 s on, timed "
          "against the 88-line algorithm of Hu et al. (2018).",
          transfer),
      .run = run,
      .levels = {timed("A2", dam_cell / 2, dam_cell), timed("A4", dam_cell / 4, dam_cell)},
      .claims = {at_least(faster, least_of_4, kept).on("A2"), at_least(faster, least_of_16, kept).on("A4")}};
}

/// The accurate methods of SPH, each against the printed one. `most` are the ratios that they must not exceed.
std::vector<Method> of_accurate_sph() {
  const auto rates = [](const std::string& name, const std::string& words, const auto& run, Level level, double most) {
    return Method{
        .name = name,
        .description = words +
                       ": its right-hand side is timed alternately with that of the printed method, which "
                       "has 20 listed neighbours and one pass over the pairs.",
        .run = [run](const Level& of,
                     const Schedule& when) { return median_of_tries(slower_rates, [&] { return run(of, when); }); },
        .levels = {std::move(level)},
        .claims = {at_most(slower_rates, most, most_measured)}};
  };
  const Level in_dam = timed("S2", dam_cell / 2), in_channel = timed("S2", channel_cell / 2),
              in_square = timed("S64", 1.0 / 64);
  const std::string second = "Smoothed particle hydrodynamics of second order", transport = "Transport-velocity SPH";
  return {
      rates("sph_delta", "delta-SPH in the dam break, 47 to 58 neighbours, two passes",
            race_free_surface([](double h, double) { return sph::Parts(sph::PressureSum{}, diffusion_in_dam(h)); }),
            in_dam, 6),
      rates("sph_corrected", "delta-SPH with corrected gradients in the dam break",
            race_free_surface([](double h, double) {
              return sph::Parts(sph::BonetLokPressure{}, diffusion_in_dam(h), sph::BonetLok{});
            }),
            in_dam, 7),
      rates("sph_shifted", "delta-SPH with shifted particles in the dam break",
            race_free_surface([](double h, double spacing) {
              return sph::Parts(sph::PressureSum{}, diffusion_in_dam(h), sph::PlainGradient{},
                                sph::TangentialShifting{spacing});
            }),
            in_dam, 8.2),
      rates(
          "sph_second_order", second + " in Poiseuille flow",
          [](const Level& level, const Schedule&) { return race_second_order(bench::channel(), level, channel_step); },
          in_channel, 3.1),
      rates(
          "sph_second_order_square", second + " in vortices",
          [](const Level& level, const Schedule&) {
            return race_second_order(vortices(), level, step_in_vortices(level));
          },
          in_square, 2.85),
      rates(
          "sph_transport_velocity", transport + " in Poiseuille flow, two passes",
          [](const Level& level, const Schedule&) {
            return race_transport_velocity(bench::channel(), level, channel_step);
          },
          in_channel, 3.4),
      rates(
          "sph_transport_velocity_square", transport + " in vortices, two passes",
          [](const Level& level, const Schedule&) {
            return race_transport_velocity(vortices(), level, step_in_vortices(level));
          },
          in_square, 3.2)};
}

/// One core, each against its plain loop.
std::vector<Method> on_one_core() {
  return {
      {
          .name = "mpm",
          .description = channel::mpm_words + channel::moving_words +
                         " Timed in Poiseuille flow against the same method as plain loops over particles and nodes.",
          .run = race_mpm(bench::channel(), channel_step),
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
          .description = "Cost of monitoring a run of the material point method as printed, whose steps are the "
                         "cheapest.",
          .run = time_the_monitor(mpm_solver<>),
          .levels = {timed("M1", channel_cell, channel_cell), timed("M4", channel_cell / 4, channel_cell)},
          .claims = {at_most(monitor_cost, 1, set_goal)},
      },
      {
          .name = "sph_watched",
          .description = "Cost of monitoring a run of smoothed particle hydrodynamics as printed.",
          .run = time_the_monitor(sph_printed_solver<>),
          .levels = {timed("S1", channel_cell)},
          .claims = {at_most(monitor_cost, 1, set_goal)},
      },
      {
          .name = "mpm_single",
          .description = "Material point method as printed, with particles in single precision, timed in Poiseuille "
                         "flow; the plain loop is in double precision.",
          .run = race_mpm<float>(bench::channel(), channel_step),
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
          .name = "mpm_least_squares",
          .description =
              "Material point method by least squares in the manufactured flow without its force, timed against the "
              "plain loop of the printed method over as many particles.",
          .run = race_least_squares,
          .levels = {timed("A2", 1.0 / 96, 1.0 / 48)},
          .claims = {at_least(faster, 0.52,
                              baseline("goal set: 60 ns where the plain loop takes 31; 0.65 to 0.70 measured"))},
      },
      {
          // From 0.1 s on a third of the column's top has sunk.
          .name = "mpm_dam_break",
          .description = "Material point method as printed, timed in the dam break from 0.1 s on. The reference loop "
                         "stores the full stress tensor.",
          .run = race_mpm_in_dam,
          .levels = {timed("M4", dam_cell / 4, dam_cell)},
          .claims = {at_least(faster, 2.5, goal)},
      },
      race_of_splines("mpm_apic_dam_break", "affine velocities (APIC)", race_splines<mpm::Apic>, 1.4, 2.1),
      race_of_splines("mpm_xpic_dam_break", "velocities by XPIC(5)", race_splines<mpm::Xpic<5>>, 0.75, 1.7),
      {
          .name = "mpm_empty_background",
          .description = "Material point method as printed: the column of the dam break in tanks 1, 10 and 100 times "
                         "as large as the paper's.",
          .run = [](const Level& level,
                    const Schedule&) { return median_of_tries(slower, [&] { return compare_tanks(level); }); },
          .levels = {timed("1", dam_cell / 4, dam_cell), timed("10", dam_cell / 4, dam_cell),
                     timed("100", dam_cell / 4, dam_cell)},
          .claims = {between(slower, 0.9, 1.1, set_goal)},
      },
      {
          .name = "sph",
          .description = channel::sph_printed_words + plain_sph_words,
          .run = race_sph<PredictorCorrector>(bench::channel(), channel_step, laminar),
          .levels = {timed("S2", channel_cell / 2)},
          .claims = {at_least(faster_rates, 2.5, goal), at_least(scaled_rate, 7, goal)},
      },
      {
          .name = "sph_dam_break",
          .description = column_words,
          .run = race_sph<PredictorCorrector>(dam(), dam_sph_step, artificial),
          .levels = {timed("S4", dam_cell / 4)},
          .claims = {at_least(faster_rates, 2.5, goal)},
      },
      {
          .name = "sph_one_evaluation",
          .description = "Smoothed particle hydrodynamics as printed, but by Adams-Bashforth with one right-hand side "
                         "per step, in Poiseuille flow.",
          .run = race_sph<AdamsBashforth>(bench::channel(), channel_step, laminar),
          .levels = {timed("S2", channel_cell / 2)},
          .claims = {at_least(faster_rates, 2.5, goal), at_least(scaled_rate, 13, goal)},
      },
      {
          .name = "sph_one_evaluation_dam_break",
          .description = column_words + " By Adams-Bashforth, with one right-hand side per step.",
          .run = race_sph<AdamsBashforth>(dam(), dam_sph_step, artificial),
          .levels = {timed("S4", dam_cell / 4)},
          .claims = {at_least(faster_rates, 2.5, goal), at_least(scaled_rate, 8, goal)},
      }};
}

std::vector<Method> on_this_machine() {
  std::vector<Method> all = on_one_core();
  for (Method& method : of_accurate_sph()) all.push_back(std::move(method));
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
