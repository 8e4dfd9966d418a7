#pragma once
/// The largest stable time step, found by trying.

#include "solvers/diverged.hpp"
#include "vnv/run.hpp"

#include <cmath>

namespace touchstone::vnv {

/// Where to look, and what counts as unstable.
struct StepSearch {
  double low, high;         // s  a stable and an unstable time step to begin with
  double tolerance = 0.01;  // of the critical step
  long steps = 2000;        // in each trial
  double speed_limit;       // m/s  the flow never comes near this; what exceeds it has blown up
};

/// Whether a solver keeps below the speed limit; one that diverges does not. Counts the steps it takes.
template <class Solver>
bool is_stable(Solver solver, const StepSearch& search, long& steps) {
  try {
    for (long k = 0; k < search.steps; ++k) {
      solver.step();
      ++steps;
      if (k % 50 == 49 && !(sound(solver.samples(), solver.steps()).v.colwise().norm().maxCoeff() < search.speed_limit))
        return false;
    }
    return true;
  } catch (const Diverged&) {
    return false;
  }
}

/// A bracket of the critical time step: stable at `low`, unstable at `high`.
struct CriticalStep {
  double low, high;  // s
  long steps = 0;    // that all trials took
};

/// Bisects between a stable and an unstable step; `solver_with(dt)` makes a solver. Throws std::invalid_argument if the
/// ends are not what they are said to be.
template <class Factory>
CriticalStep critical_step(Factory solver_with, const StepSearch& search) {
  CriticalStep bracket{search.low, search.high};
  if (!is_stable(solver_with(search.low), search, bracket.steps))
    throw std::invalid_argument(fmt::format("critical step: {} s is unstable, wanted a stable lower end", search.low));
  if (is_stable(solver_with(search.high), search, bracket.steps))
    throw std::invalid_argument(
        fmt::format("critical step: {} s is stable, wanted an unstable upper end", search.high));
  while (bracket.high > bracket.low * (1 + search.tolerance)) {
    const double middle = std::sqrt(bracket.low * bracket.high);
    (is_stable(solver_with(middle), search, bracket.steps) ? bracket.low : bracket.high) = middle;
  }
  return bracket;
}

/// The same as a run of a case: the critical step and its ratio to the Courant limit (31) of Sun et al., length / c.
template <class Factory>
Run search_critical_step(Factory solver_with, const StepSearch& search, double length, double sound_speed) {
  Run run;
  const CostMeter meter;
  const CriticalStep found = critical_step(solver_with, search);
  const double courant = length / sound_speed;
  run.found = {{"", 0, not_a_number, "critical time step, stable end [us]", found.low / us},
               {"", 0, not_a_number, "critical time step, unstable end [us]", found.high / us},
               {"", 0, not_a_number, "critical time step over (31) [-]", found.low / courant}};
  run.summary.finished = true;
  run.summary.outcome = "finished";
  run.summary.time_step = found.low;
  const auto solver = solver_with(found.low);
  run.summary.cost = meter.read();
  run.summary.cost.stepping = run.summary.cost.wall;
  run.summary.cost.particles = solver.particles();
  run.summary.cost.boundary_particles = solver.boundary_particles();
  run.summary.cost.steps = found.steps;
  return run;
}

}  // namespace touchstone::vnv
