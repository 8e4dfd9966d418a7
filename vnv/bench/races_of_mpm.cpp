#include "solvers/mpm/lanes/in_lanes.hpp"
#include "solvers/mpm/least_squares/least_squares.hpp"
#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "vnv/bench/mls_mpm.hpp"
#include "vnv/bench/plain_musl.hpp"
#include "vnv/bench/race.hpp"
#include "vnv/bench/scenes.hpp"
#include "vnv/flows/channels/channel.hpp"
#include "vnv/run/state_check.hpp"

namespace touchstone::bench {
namespace {

using namespace vnv;

mpm::Settings mpm_settings(const Level& level, double time_step, int threads = 1) {
  return {.cell = level.cell, .spacing = level.spacing, .time_step = time_step, .threads = threads};
}

template <class Number = double, class AnyScene>
auto printed_mpm(const AnyScene& scene, const Level& level, double time_step, int threads = 1) {
  return mpm::printed<mpm::PrescribedMotion, Number>(scene, mpm_settings(level, time_step, threads));
}

/// The dam break from 0.1 s, when a third of the column's top has sunk, to 0.4 s.
Course in_dam(double time_step) {
  return {.lead = std::lround(0.1 / time_step), .stretch = std::lround(0.3 / time_step)};
}

/// As printed, particles in single precision where `Number` is float.
template <class Number = double, class AnyScene>
auto race_mpm(const AnyScene& scene, double time_step, const Course& course = {}) {
  return [=](const Level& level, const Schedule&) {
    return race(printed_mpm<Number>(scene, level, time_step),
                PlainMusl(plain(scene), level.cell, level.spacing, time_step), course);
  };
}

/// With B-splines, against the 88-line algorithm.
template <class Shape, class Transfer, class Density = mpm::CarriedDensity, class AnyScene>
auto race_splines(const AnyScene& scene, double time_step, const Course& course = {}) {
  return [=](const Level& level, const Schedule&) {
    return race(mpm::in_lanes<Shape, Transfer, Density>(scene, mpm_settings(level, time_step)),
                MlsMpm(plain(scene), level.cell, level.spacing, time_step), course);
  };
}

template <class Transfer>
Method race_splines_in_dam(const std::string& name, const std::string& transfer) {
  constexpr double time_step = 2 * dam_mpm_step;
  return {
      .name = name,
      .description = fmt::format(
          "Material point method on quadratic B-splines, {}, affine densities, in the dam break from 0.1 s on, timed "
          "against the 88-line algorithm of Hu et al. (2018).",
          transfer),
      .run = race_splines<mpm::BSpline<2>, Transfer, mpm::AffineDensity>(dam(), time_step, in_dam(time_step))};
}

/// By least squares in vortices, against as many particles of the plain loop in a square channel.
Run race_least_squares(const Level& level, const Schedule&) {
  const double time_step = 0.3 * level.cell / vortices().fluid.sound_speed(), side = channel_cell / level.cell;
  return race(mpm::least_squares(vortices(), mpm_settings(level, time_step)),
              PlainMusl(plain(channel(side, side)), channel_cell, channel_cell / 2, channel_step), {.lead = 100});
}

/// What the run loop takes to evaluate all particles, in turn with the steps that it lets pass between two samples.
auto time_the_monitor(Simulation (*solver)(const Scene<Newtonian, Uniform>&, const Level&, double)) {
  return [=](const Level& level, const Schedule&) {
    Simulation simulation = solver(channel(), level, channel_step);
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

/// The column in tanks as many times as large as the paper's as the level's name says.
Run compare_tanks(const Level& level, const Schedule&) {
  const double larger = std::stod(level.name), longer = std::min(larger, 10.0);
  const Vec2 tank = dam_tank.cwiseProduct(Vec2(longer, larger / longer));
  return tries(3, slower, [&] {
    auto small = printed_mpm(dam(), level, dam_mpm_step), large = printed_mpm(dam(tank), level, dam_mpm_step);
    const Times times = time_in_turn({[&] { large.step(); }, [&] { small.step(); }});
    Run run = run_of(large, times.of(0));
    run.add(slower, times.ratio(0, 1));
    run.add(spread, 100 * times.spread(0, 1));
    run.add(empty_fraction, 100 * (1 - dam().filled.size().prod() / tank.prod()));
    return run;
  })[1];
}

}  // namespace

std::vector<Method> races_of_mpm() {
  return {
      {.name = "mpm",
       .description = vnv::channel::mpm_words + vnv::channel::moving_words +
                      " Timed in Poiseuille flow against the same method as plain loops over particles and nodes.",
       .run = race_mpm(channel(), channel_step)},
      {.name = "mpm_watched",
       .description = "Cost of monitoring a run of the material point method as printed, whose steps are the cheapest.",
       .run = time_the_monitor(mpm_solver<>)},
      {.name = "sph_watched",
       .description = "Cost of monitoring a run of smoothed particle hydrodynamics as printed.",
       .run = time_the_monitor(sph_printed_solver<>)},
      {.name = "mpm_single",
       .description = "Material point method as printed, with particles in single precision, timed in Poiseuille "
                      "flow; the plain loop is in double precision.",
       .run = race_mpm<float>(channel(), channel_step)},
      {.name = "mpm_affine",
       .description =
           "Affine material point method on quadratic B-splines, timed in Poiseuille flow against the 88-line "
           "algorithm of Hu et al. (2018).",
       .run = race_splines<mpm::QuadraticBSpline, mpm::MlsApic>(channel(), channel_step)},
      {.name = "mpm_least_squares",
       .description = "Material point method by least squares in the manufactured flow without its force, timed "
                      "against the plain loop of the printed method over as many particles.",
       .run = race_least_squares},
      {.name = "mpm_dam_break",
       .description = "Material point method as printed, timed in the dam break from 0.1 s on. The reference loop "
                      "stores the full stress tensor.",
       .run = race_mpm(dam(), dam_mpm_step, in_dam(dam_mpm_step))},
      race_splines_in_dam<mpm::Apic>("mpm_apic_dam_break", "affine velocities (APIC)"),
      race_splines_in_dam<mpm::Xpic<5>>("mpm_xpic_dam_break", "velocities by XPIC(5)"),
      {.name = "mpm_empty_background",
       .description = "Material point method as printed: the column of the dam break in tanks 1, 10 and 100 times "
                      "as large as the paper's.",
       .run = compare_tanks},
      {.name = "mpm_threads",
       .description = "Material point method, linear hats," + words_of_threads,
       .run = compare_threads([](const Level& level, int threads) {
         return printed_mpm(channel(8 * channel_length), level, channel_step, threads);
       })}};
}

}  // namespace touchstone::bench
