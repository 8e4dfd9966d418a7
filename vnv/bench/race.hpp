#pragma once
/// A solver timed in turn with something else that does the same work, as a run of a case.

#include "solvers/threads.hpp"
#include "vnv/bench/in_turn.hpp"
#include "vnv/case.hpp"
#include "vnv/run/lap_clock.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <stdexcept>

namespace touchstone::bench {

// What a race finds.
inline const vnv::Quantity faster{"speed-up over the reference loop", "", vnv::Kind::cost, vnv::Better::larger};
inline const vnv::Quantity faster_rates{"right-hand side: speed-up over the reference loop", "", vnv::Kind::cost,
                                        vnv::Better::larger};
inline const vnv::Quantity slower_rates{"right-hand side over that of the printed method", "", vnv::Kind::cost};
inline const vnv::Quantity solver_time{"solver", "ns per particle-step", vnv::Kind::cost};
inline const vnv::Quantity loop_time{"plain loop", "ns per particle-step", vnv::Kind::cost};
inline const vnv::Quantity spread{"half interquartile range of the speed-up", "%", vnv::Kind::cost};
inline const vnv::Quantity lap_cost{"time of a step with sub-step timing over one without", "", vnv::Kind::cost};
/// Where the peers were measured, the right-hand side of a scalar loop over full lists took so long [ns]: a rate is
/// scaled by it so as to stand beside theirs.
inline constexpr double plain_rates_where_peers_ran = 114;
inline const vnv::Quantity scaled_rate{"million particle-steps/s, scaled to the machine of the published codes", "1/us",
                                       vnv::Kind::cost, vnv::Better::larger};
inline const vnv::Quantity monitor_cost{"time of a monitor sample over that of the steps between two", "%",
                                        vnv::Kind::cost};
inline const vnv::Quantity empty_fraction{"empty fraction of the tank", "%"};
inline const vnv::Quantity slower{"time per step over that in the tank of the paper", "", vnv::Kind::cost};
inline const vnv::Quantity used{"speed-up with two threads over the throughput of two concurrent runs", "",
                                vnv::Kind::cost, vnv::Better::larger};
inline vnv::Quantity time_of(SubStep part) {
  return {std::string(names_of_sub_steps[static_cast<std::size_t>(part)]), "ns per particle-step", vnv::Kind::cost};
}

/// A run whose cost is that of the median step.
template <class Solver>
vnv::Run run_of(const Solver& solver, double per_step) {
  vnv::Run run;
  run.summary = {.time_step = solver.time_step(), .end_time = solver.time(), .finished = true, .outcome = "finished"};
  run.summary.cost.particles = solver.particles();
  run.summary.cost.boundary_particles = solver.boundary_particles();
  run.summary.cost.steps = solver.steps();
  run.summary.cost.cpu = run.summary.cost.wall = per_step * static_cast<double>(solver.steps());
  return run;
}

/// Sub-steps, as their fractions of the median step.
inline void found_laps(vnv::Run& run, const vnv::LapClock& laps, double per_particle_step) {
  for (std::size_t k = 0; k < names_of_sub_steps.size(); ++k)
    if (const double fraction = laps.per_step(SubStep(k)) / laps.per_step(); fraction > 0)
      run.add(time_of(SubStep(k)), 1e9 * fraction * per_particle_step);
}

/// The steps of a race: as many as the machine and its load allow, after `lead` of both. A solver that has gone
/// `stretch` steps from there goes back: some time after the impact a dam break leaves its tank.
struct Course {
  long lead = 0, stretch = std::numeric_limits<long>::max();
};

/// A solver against a plain loop.
template <class Solver, class Loop>
vnv::Run race(Solver solver, Loop loop, const Course& course = {}, const Effort& effort = {}) {
  for (long k = 0; k < course.lead; ++k) solver.step(), loop.step();
  std::optional<Solver> now(solver);
  const auto ready = [&]() -> Solver& {
    if (now->steps() - course.lead == course.stretch) now.emplace(solver);
    return *now;
  };
  vnv::LapClock laps(16);
  const Times times =
      time_in_turn({[&] { ready().step(); }, [&] { loop.step(); }, [&] { laps.step(ready()); }}, effort);
  vnv::Run run = run_of(*now, times.of(0));
  const double each = times.of(0) / static_cast<double>(solver.particles());
  run.add(faster, times.ratio(1, 0));
  run.add(spread, 100 * times.spread(1, 0));
  run.add(solver_time, 1e9 * each);
  run.add(loop_time, 1e9 * times.of(1) / static_cast<double>(loop.particles().size()));
  run.add(lap_cost, times.ratio(2, 0));
  found_laps(run, laps, each);
  return run;
}

/// A solver with one right-hand side a step against the printed method, which finds two, over as many particles of the
/// same flow: all but the search for neighbours.
template <class Solver, class Printed>
vnv::Run race_with_printed(Solver solver, Printed printed, long lead = 0) {
  for (long k = 0; k < lead; ++k) solver.step(), printed.step();
  vnv::LapClock laps, laps_of_printed;
  const Times times = time_in_turn({[&] { laps.step(solver); }, [&] { laps_of_printed.step(printed); }});
  const auto without_sorting = [](const vnv::LapClock& of) {
    return 1 - of.per_step(SubStep::sorting) / of.per_step();
  };
  vnv::Run run = run_of(solver, times.of(0));
  run.add(slower_rates, 2 * times.ratio(0, 1) * without_sorting(laps) / without_sorting(laps_of_printed));
  run.add(spread, 100 * times.spread(0, 1));
  run.add(solver_time, 1e9 * times.of(0) / static_cast<double>(solver.particles()));
  found_laps(run, laps, times.of(0) / static_cast<double>(solver.particles()));
  return run;
}

/// The same with the right-hand sides alone, of which the solver finds so many a step; without a lead.
template <class Solver, class Loop>
vnv::Run race_with_rates(Solver solver, Loop loop, int per_step, const Effort& effort = {.seconds = 0.04}) {
  vnv::Run run = race(solver, loop, {}, effort);
  vnv::LapClock laps;
  const Times times = time_in_turn({[&] { laps.step(solver); }, [&] { loop.find_rates(); }}, effort);
  const double fraction = (laps.per_step(SubStep::pairs) + laps.per_step(SubStep::rates)) / laps.per_step();
  run.add(faster_rates, times.ratio(1, 0) / fraction * per_step);
  run.add(scaled_rate, 1e3 * times.ratio(1, 0) / plain_rates_where_peers_ran);
  return run;
}

/// Runs of several tries, sorted by that quantity. Solvers that are made anew lie elsewhere in memory, which alone may
/// change a ratio of times by more than a tenth, for as long as they live.
std::vector<vnv::Run> tries(std::size_t number, const vnv::Quantity& quantity,
                            const std::function<vnv::Run()>& attempt);

// One thread and two, by the clock on the wall. Two processors of a machine that does other things too, or that heat
// each other, give less than twice the work of one: two runs side by side, each on one thread, show how much.
inline const vnv::Quantity speed_up{"speed-up with two threads", "", vnv::Kind::cost, vnv::Better::larger};
inline const vnv::Quantity two_at_once{"throughput of two concurrent runs over that of one", "", vnv::Kind::cost,
                                       vnv::Better::larger};

inline const std::string words_of_threads =
    " in eight lengths of the paper's channel: 102400 particles, bitwise identical results for any number of threads.";

/// `make`(level, threads) makes a solver. The best of five: where memory lies badly it is not the threads that cost,
/// and where something else takes a processor for a while two threads wait for each other, but two runs do not.
template <class Make>
auto compare_threads(Make make) {
  return [=](const vnv::Level& level, const vnv::Schedule&) {
    return tries(5, used,
                 [&] {
                   auto one = make(level, 1), other = make(level, 1), two = make(level, 2);
                   const auto side_by_side = [&] {
                     share_out(2, 2, [&](Eigen::Index which, Eigen::Index) { which == 0 ? one.step() : other.step(); });
                   };
                   const Times times = time_in_turn({[&] { one.step(); }, [&] { two.step(); }, side_by_side},
                                                    {.rounds = 31, .seconds = 0.05, .clock = wall_time});
                   vnv::Run run = run_of(two, times.of(1));
                   run.add(speed_up, times.ratio(0, 1));
                   run.add(two_at_once, 2 * times.ratio(0, 2));
                   run.add(used, times.ratio(2, 1) / 2);
                   run.add(spread, 100 * times.spread(0, 1));
                   return run;
                 })
        .back();
  };
}

/// What is raced: names, descriptions and runs; levels and claims are the case's.
std::vector<vnv::Method> races_of_mpm();
std::vector<vnv::Method> races_of_sph();

/// The one of a name. Throws std::invalid_argument for a name that none has.
inline vnv::Method race_named(const std::string& name) {
  for (const auto& races : {races_of_mpm(), races_of_sph()})
    for (const vnv::Method& race : races)
      if (race.name == name) return race;
  throw std::invalid_argument(fmt::format("bench: no race '{}'", name));
}

/// Where a step's time goes, for each level that was raced.
void tabulate_sub_steps(const vnv::Results& results, vnv::Record& record);
/// The time of a step over the empty fraction of the tank.
void draw_empty_background(const vnv::Results& results, vnv::Record& record);

}  // namespace touchstone::bench
