#pragma once
/// What a case file declares: scene, oracle, measures, methods, limits and plots, and no loop.

#include "vnv/files/data_folder.hpp"
#include "vnv/judge/claims.hpp"
#include "vnv/run/run.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace touchstone::vnv {

struct Record;

enum class Suite { acceptance, report, nightly, work, validation };
inline constexpr std::array suites{Suite::acceptance, Suite::report, Suite::nightly, Suite::work, Suite::validation};
inline std::string_view name_of(Suite suite) {
  return std::array{"acceptance", "report", "nightly", "work", "validation"}[static_cast<std::size_t>(suite)];
}

/// One resolution of a method, and how far each suite runs it; zero: not at all.
struct Level {
  std::string name{};                      // "M2"
  double spacing;                          // m  of the particles at the start
  double cell = not_a_number;              // m  of the background grid; none in SPH
  double smoothing_length = not_a_number;  // m  of the kernel, else that of the method; none in MPM
  double time_step = not_a_number;         // s  else that of the method
  double sound_speed = not_a_number;       // m/s  else that of the scene
  double period = not_a_number;            // m  along x, else that of the scene
  double acceptance = 0;                   // s
  double report = 0;                       // s
  double nightly = 0;                      // s
  double work = 0;                         // s
  double validation = 0;                   // s
  std::string combination{};               // in the suite `work`: of all but the spacing
  bool may_diverge = false;                // a run that is made to see whether it does

  double smoothing_or(double of_method) const { return std::isnan(smoothing_length) ? of_method : smoothing_length; }
  double step_or(double of_method) const { return std::isnan(time_step) ? of_method : time_step; }  // s
  double until(Suite suite) const {
    return std::array{acceptance, report, nightly, work, validation}[static_cast<std::size_t>(suite)];
  }
};

/// Levels that differ in one thing, coarse to fine; what that is, the name says. More points in the same cell is not a
/// finer grid: these are two ladders.
struct Ladder {
  std::string name;                 // "grid at 4 points per cell"
  std::vector<std::string> levels;  // names
};

/// How far a value may be from its baseline, and why that far.
struct Tolerance {
  double relative = 1e-6;
  std::string basis = "another compiler or processor rounds otherwise";
  double absolute = 1e-12;  // in any unit: what another order of a sum leaves of zero

  /// Values whose heading contains some words may be farther from theirs.
  struct Exception {
    std::string words;
    double relative;
    std::string basis;
  };
  std::vector<Exception> exceptions{};
};

/// The material point method has a background grid, smoothed particle hydrodynamics has none.
enum class Family { undeclared, mpm, sph };

struct Method {
  std::string name{};                  // "mpm"
  Family family = Family::undeclared;  // needed where methods of both are compared
  std::string description{};           // which equations, which walls, which time step; what print leaves open
  std::function<Run(const Level&, const Schedule&)> run{};
  std::function<Simulation(const Level&, double)> solver{};  // of its scene, with a time step [s]; if runs are of one
  std::function<double(const Level&)> time_step{};           // s  the step that it takes by itself, likewise
  std::vector<Level> levels{};
  std::vector<Ladder> ladders{};
  std::vector<Claim> claims{};
  std::vector<Claim> claims_of_work{};  // judged in the suite `work`, which judges no others
  Tolerance tolerance{};
  double relative_cost = 1;   // of all its runs; ctest starts the dearest first
  double kernel_support = 3;  // smoothing lengths  of SPH: no neighbour is farther
  bool as_printed = false;    // one of the two methods of Sun et al., beside which others are shown
};

/// A method whose runs are simulations of a scene: `solver(level, time step [s])` makes one, `time_step(level)` says
/// which step it takes where the level says nothing; that one follows the flow.
template <class MakeSolver, class TimeStep>
Method simulating(Method method, MakeSolver solver, TimeStep time_step) {
  method.solver = solver;
  method.time_step = time_step;
  method.run = [=](const Level& level, const Schedule& when) {
    return simulate([&] { return Simulation(solver(level, level.step_or(time_step(level)))); }, when,
                    std::isnan(level.time_step) ? Stepping::adaptive : Stepping::as_given);
  };
  return method;
}

/// One method of a case after all its runs, as plots and tables see it.
struct Results {
  const Method& method;
  Suite suite;
  std::vector<Run> runs;

  /// The run of a level, or null if this suite has none.
  const Run* run(std::string_view level) const {
    for (const Run& r : runs)
      if (r.summary.level == level) return &r;
    return nullptr;
  }
};

/// Turns a run into named numbers, "L2 v_x, row means [%]".
using Measurement = std::function<std::vector<Value>(const Level&, const Run&)>;

/// Turns all runs of a method into named numbers that claims may speak of. They belong to the machine of today: no
/// baseline is taken of them.
using Finding = std::function<std::vector<Value>(const Results&, const Record&)>;

/// How much time may go into making short runs of a method more than once, for a reliable measure of their cost.
struct Repeats {
  double budget = 0.5;    // s  user time of all repeats of a method, beyond the first run of each level
  long most = 5;          // runs of any one level
  double longest = 0.25;  // s  user time of a run that is repeated: the cost of a longer one is reliable
};

/// Adds figures and tables to the record of a method.
using Plot = std::function<void(const Results&, Record&)>;

struct Case {
  std::string title{};
  std::string description{};
  std::vector<double> times;  // s  rising
  Monitor monitor{};
  std::vector<Measurement> measurements;
  std::vector<Finding> findings{};
  Repeats repeats{};                                                // in the suites that show cost: report and nightly
  std::vector<Claim> claims{};                                      // of any method
  std::function<double(const Level&, const Run&)> error_of_work{};  // by which that suite chooses what to refine
  double work_budget = 60;  // s  user time of the levels of a method in the suite `work`, cheapest first
  std::vector<Method> methods;
  std::vector<Plot> plots{};
  bool ensemble = false;    // levels differ by chance: baselines are of what all of them are together
  bool timed = false;       // what it judges is time: no other test runs beside it
  std::string label{};      // besides that of the suite, for ctest -L; of what acceptance runs
  std::string priced_as{};  // the case by whose error against run time the default method is chosen; empty: its own
};

/// The case with more plots.
inline Case with_plots(Case declared, const std::vector<Plot>& plots) {
  declared.plots.insert(declared.plots.end(), plots.begin(), plots.end());
  return declared;
}

/// Defined by the case file.
Case the_case();

}  // namespace touchstone::vnv
