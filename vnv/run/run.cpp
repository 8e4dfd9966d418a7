#include "vnv/run/run.hpp"

#include "solvers/stepping/diverged.hpp"
#include "vnv/programs/progress.hpp"
#include "vnv/run/state_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace touchstone::vnv {
namespace {

/// A simulation that is monitored as it goes.
class Monitored {
 public:
  Monitored(Simulation simulation, const std::string& name, double end, Stepping stepping)
      : simulation_(std::move(simulation)),
        stepping_(stepping),
        pace_(simulation_),
        state_check_(simulation_.medium(), simulation_.samples()),
        end_(end),
        progress_(name, programs::Progress::Where::terminal) {}

  /// Steps until its time is nearest to a target [s], in steps that may be longer than those before. Throws Diverged.
  void step_to(double target) {
    constexpr long batch = 50;  // the clock is read, and the pace kept, once in so many steps
    bool may_lengthen = true;
    for (long left = steps_to(target); left > 0; left = steps_to(target)) {
      if (stepping_ == Stepping::adaptive) {
        keep_pace(target, may_lengthen);
        left = steps_to(target);
        may_lengthen = false;
      }
      const StopWatch watch;
      for (long k = std::min(left, batch); k > 0; --k) simulation_.step();
      seconds_ += watch.seconds();
      progress_.show([&] { return how_far(); });
      if (simulation_.steps() - last_checked_ >= steps_between_checks) checked_samples();
    }
  }

  /// Throws Diverged for what has left the weakly compressible range.
  Samples checked_samples() {
    Samples samples = simulation_.samples();
    state_check_.require(samples, simulation_.steps());
    last_checked_ = simulation_.steps();
    return samples;
  }

  const Simulation& simulation() const { return simulation_; }
  const std::vector<StepChange>& changes() const { return changes_; }
  long last_checked() const { return last_checked_; }  // the step after which it was last found sound
  double stepping() const { return seconds_; }         // s  wall time of all steps

 private:
  long steps_to(double target) const {
    return std::lround(std::ceil((target - simulation_.time()) / simulation_.time_step() - 0.5));
  }

  /// Shortens the steps to a whole number of them up to the target [s] where the flow needs it, and takes the given one
  /// again where it does not.
  void keep_pace(double target, bool may_lengthen) {
    const double longest = pace_.longest(simulation_), now = simulation_.time_step();
    if (longest >= now && !may_lengthen) return;
    const double left = target - simulation_.time();
    const double next = longest < pace_.given() ? left / std::ceil(left / longest * (1 - 1e-9)) : longest;
    if (std::abs(next - now) <= 1e-9 * now) return;
    simulation_.change_time_step(next);
    changes_.push_back({simulation_.steps(), next});
  }

  /// "40 %, about 12 s left"
  std::string how_far() const {
    const double part = simulation_.time() / end_;
    if (!(part > 0)) return "begins";
    const std::chrono::duration<double> taken = programs::Progress::Clock::now() - start_;
    return fmt::format("{:.0f} %, about {} left", 100 * part,
                       programs::duration_in_words(std::max(0.0, taken.count() * (1 / part - 1))));
  }

  Simulation simulation_;
  Stepping stepping_;
  Pace pace_;
  std::vector<StepChange> changes_;
  StateCheck state_check_;
  double end_;  // s
  programs::Progress progress_;
  programs::Progress::Clock::time_point start_ = programs::Progress::Clock::now();
  long last_checked_ = 0;
  double seconds_ = 0;
};

/// How the run ends when it is made again and evaluated after each step from the last sound sample on; `outcome`
/// is how it ended before.
std::string run_closely(Simulation simulation, const Monitored& monitored, const std::string& outcome) {
  try {
    const StateCheck state_check(simulation.medium(), simulation.samples());
    auto change = monitored.changes().begin();
    while (simulation.steps() <= monitored.last_checked() + steps_between_checks) {
      for (; change != monitored.changes().end() && change->after == simulation.steps(); ++change)
        simulation.change_time_step(change->time_step);
      simulation.step();
      if (simulation.steps() > monitored.last_checked()) state_check.require(simulation.samples(), simulation.steps());
    }
  } catch (const Diverged& diverged) {
    return diverged.what();
  }
  return outcome;  // a solver that is not the same each time
}

/// Samples at the times of the schedule, and what is monitored, into the run.
void sample(Monitored& monitored, const Schedule& when, Run& run) {
  const double dt = run.summary.time_step;
  std::size_t kept = 0;
  for (long rows = 0; kept < when.times.size();) {
    const double next_monitored =
        when.monitor.evaluate ? static_cast<double>(rows) * when.monitor.interval : when.times.back();
    const double target = std::min(next_monitored, when.times[kept]);
    monitored.step_to(target);
    Samples samples = monitored.checked_samples();
    if (std::abs(samples.time - target) < 1e-9 * target) samples.time = target;  // but for rounding
    if (when.monitor.evaluate && next_monitored <= target + dt / 2) {
      run.history.time.push_back(samples.time);
      run.history.values.push_back(when.monitor.evaluate(samples));
      ++rows;
    }
    if (when.times[kept] <= target + dt / 2) {
      run.samples.push_back(std::move(samples));
      ++kept;
    }
  }
}

}  // namespace

Run run_of_trials(const CostMeter& meter, long particles, long boundary_particles, long steps) {
  Run run;
  run.summary.finished = true;
  run.summary.outcome = "finished";
  Cost& cost = run.summary.cost;
  cost = meter.read();
  cost.stepping = cost.wall;
  cost.particles = particles;
  cost.boundary_particles = boundary_particles;
  cost.steps = steps;
  return run;
}

Run simulate(const MakeSimulation& make, const Schedule& when, Stepping stepping) {
  if (when.monitor.evaluate && !(when.monitor.interval > 0 && std::isfinite(when.monitor.interval)))
    throw std::invalid_argument(
        fmt::format("{}: monitor interval {} s, expected a positive time", when.name, when.monitor.interval));
  Run run;
  Monitored monitored(make(), when.name, when.times.back(), stepping);
  const Simulation& simulation = monitored.simulation();
  run.summary.time_step = simulation.time_step();
  run.room = simulation.room();
  const CostMeter meter;
  std::string fault;
  try {
    sample(monitored, when, run);
    run.summary.finished = true;
    run.summary.outcome = "finished";
  } catch (const Diverged& diverged) {
    fault = diverged.what();
  }
  Cost& cost = run.summary.cost;
  cost = meter.read();
  cost.stepping = monitored.stepping();
  cost.harness = cost.wall - cost.stepping;
  cost.particles = simulation.particles();
  cost.boundary_particles = simulation.boundary_particles();
  cost.steps = simulation.steps();
  run.summary.end_time = run.summary.finished ? when.times.back() : simulation.time();
  if (!run.summary.finished) run.summary.outcome = run_closely(make(), monitored, fault);
  if (!monitored.changes().empty())
    run.add(shortest_step_taken,
            std::ranges::min(monitored.changes(), {}, &StepChange::time_step).time_step / run.summary.time_step);
  return run;
}

}  // namespace touchstone::vnv
