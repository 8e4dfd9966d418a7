#pragma once
/// The only time loop: step to each asked time, take samples, keep account of what it cost.

#include "solvers/diverged.hpp"
#include "solvers/samples.hpp"
#include "vnv/cost.hpp"
#include "vnv/progress.hpp"
#include "vnv/record.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::vnv {

/// Numbers that are followed over time, more often than all particles are kept.
struct Watch {
  double every = std::numeric_limits<double>::infinity();  // s
  std::function<std::vector<double>(const Samples&)> see{};
};

/// When to look at a run.
struct Schedule {
  std::vector<double> times;  // s  rising; all particles are kept at these, and the run ends at the last
  Watch watch{};
  std::string name{};  // for the progress line
};

/// What the watch saw.
struct History {
  std::vector<double> time;               // s
  std::vector<std::vector<double>> seen;  // one row a time
};

/// What came of one run. A diverged run holds what was sampled before.
struct Run {
  RunSummary summary{};
  std::vector<Samples> samples{};
  History history{};
  std::vector<Error> found{};  // values that the run itself measured, such as a critical time step

  /// The samples at a time [s], or null. Times agree to half a time step.
  const Samples* at(double time) const {
    for (const Samples& s : samples)
      if (std::abs(s.time - time) <= 0.51 * summary.time_step) return &s;
    return nullptr;
  }
};

/// Samples of a run that goes on being a flow; throws Diverged for a velocity or density that is not.
inline Samples sound(Samples s, long step) {
  for (Eigen::Index p = 0; p < s.size(); ++p) {
    const auto refuse = [&](const char* quantity, double value, const char* wanted) {
      throw Diverged({step, s.time, p, s.x.col(p), quantity, value, wanted});
    };
    if (!s.v.col(p).allFinite()) refuse("speed [m/s]", s.v.col(p).norm(), "a finite number");
    if (!(s.density[p] > 0 && std::isfinite(s.density[p])))
      refuse("density [kg/m³]", s.density[p], "a positive number");
  }
  return s;
}

/// Steps a solver until its time is nearest to a target. Returns the wall time of the steps [s]; the clock is read
/// once in so many steps.
template <class Solver>
double step_to(Solver& solver, double target, Progress& progress) {
  constexpr long batch = 100;
  double stepping = 0;
  for (long left = std::lround(std::ceil((target - solver.time()) / solver.time_step() - 0.5)); left > 0;
       left -= batch) {
    const StopWatch watch;
    for (long k = std::min(left, batch); k > 0; --k) solver.step();
    stepping += watch.seconds();
    progress.show(solver.time());
  }
  return stepping;
}

/// Runs a solver to the last time of the schedule. Divergence is a result, not an error.
template <class Solver>
Run record(Solver solver, const Schedule& when) {
  if (when.watch.see && !(when.watch.every > 0 && std::isfinite(when.watch.every)))
    throw std::invalid_argument(
        fmt::format("{}: watch every {} s, wanted a positive time", when.name, when.watch.every));
  Run run;
  CostMeter meter;
  Progress progress(when.name, when.times.back());
  const double dt = solver.time_step();
  run.summary.time_step = dt;
  double stepping = 0;  // s
  try {
    std::size_t kept = 0;
    for (long looks = 0; kept < when.times.size();) {
      const double next_look = when.watch.see ? static_cast<double>(looks) * when.watch.every : when.times.back();
      const double target = std::min(next_look, when.times[kept]);
      stepping += step_to(solver, target, progress);
      Samples samples = sound(solver.samples(), solver.steps());
      if (std::abs(samples.time - target) < 1e-9 * target) samples.time = target;  // but for rounding
      if (when.watch.see && next_look <= target + dt / 2) {
        run.history.time.push_back(samples.time);
        run.history.seen.push_back(when.watch.see(samples));
        ++looks;
      }
      if (when.times[kept] <= target + dt / 2) {
        run.samples.push_back(std::move(samples));
        ++kept;
      }
    }
    run.summary.finished = true;
    run.summary.outcome = "finished";
  } catch (const Diverged& diverged) {
    run.summary.outcome = diverged.what();
  }
  run.summary.end_time = run.summary.finished ? when.times.back() : solver.time();
  run.summary.cost = meter.read();
  run.summary.cost.stepping = stepping;
  run.summary.cost.harness = run.summary.cost.wall - stepping;
  run.summary.cost.particles = solver.particles();
  run.summary.cost.boundary_particles = solver.boundary_particles();
  run.summary.cost.steps = solver.steps();
  return run;
}

}  // namespace touchstone::vnv
