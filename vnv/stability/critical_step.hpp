#pragma once
/// The largest stable time step, found by trying, and how fast disturbances grow beyond it.

#include "vnv/case.hpp"

namespace touchstone::vnv {

/// Makes a simulation with a time step [s].
using SolverWith = std::function<Simulation(double)>;

/// Where to search, and what counts as unstable.
struct StepSearch {
  double low, high;             // s  a stable and an unstable time step to begin with
  double tolerance = 0.01;      // of the critical step
  long steps = 2000;            // in each trial
  double speed_limit;           // m/s  the flow never comes near this; what exceeds it has blown up
  Vec2 carried = Vec2::Zero();  // m/s  relative to which speeds are taken
};

/// Whether a simulation keeps below the speed limit; one that diverges does not. Counts the steps it takes.
bool is_stable(Simulation simulation, const StepSearch& search, long& steps);

/// A bracket of the critical time step: stable at `low`, unstable at `high`.
struct CriticalStep {
  double low, high;  // s
  long steps = 0;    // that all trials took
};

/// Bisects between a stable and an unstable step. Throws std::invalid_argument if the ends are not what they are said
/// to be.
CriticalStep critical_step(const SolverWith& solver_with, const StepSearch& search);

/// The largest stable step between the ends of a search [s]: the upper end if that is stable, not a number if the lower
/// one is not.
double largest_step(const SolverWith& solver_with, const StepSearch& search);

/// By which factor the fastest particle's speed grows in a step, by a line through its logarithm over the last two
/// thirds of the way to the speed limit. Not a number for a simulation that does not get there, or in fewer than six
/// steps.
double growth_per_step(Simulation simulation, const StepSearch& search);

inline const Quantity stable_end{"largest stable time step, lower bound", "us", Kind::stability_limit},
    unstable_end{"largest stable time step, upper bound", "us", Kind::stability_limit},
    over_courant{"largest stable time step over the Courant limit (31)", "", Kind::stability_limit},
    growth_beyond{"growth per step at 1.05 times the largest stable step", "", Kind::value, Better::smaller};

/// The step that a method takes where a scene names none, and that it is a stable one.
inline const Quantity step_chosen{"chosen time step over the largest stable one", "", Kind::value, Better::smaller};
inline const Claim chosen_is_stable =
    at_most(step_chosen, 0.95, theory("the time step that a method chooses must be stable"));

/// How far a stability limit may be from its baseline.
inline const Tolerance moved_limit{0.03, "a change of a stability limit by more than 3 % has to be accepted"};

/// The search as a run of a case: bracket, ratio to the Courant limit (31) of Sun et al., length / c, and growth.
Run search_critical_step(const SolverWith& solver_with, const StepSearch& search, double length, double sound_speed);

/// A column of a table of limits, and the quantity in it.
struct LimitColumn {
  std::string heading;
  Quantity quantity;
};

/// A table of what each run found; `levels` heads the column of their names.
Plot limits_table(std::string title, std::string caption, std::string levels, std::vector<LimitColumn> columns);

/// What most such tables have to say.
inline const std::string words_of_limits =
    "As acoustic Courant numbers, based on cells of four particles in MPM and on spacings in SPH; growth is that of "
    "the maximum particle speed per step at 1.05 times the largest stable step.";

}  // namespace touchstone::vnv
