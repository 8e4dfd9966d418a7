#pragma once
/// The only time loop: step to each asked time, take samples, keep account of what it cost.

#include "vnv/record/figure.hpp"
#include "vnv/record/run_summary.hpp"
#include "vnv/record/value.hpp"
#include "vnv/run/cost.hpp"
#include "vnv/run/pace.hpp"
#include "vnv/run/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv {

/// Numbers that are followed over time, more often than all particles are kept.
struct Monitor {
  double interval = std::numeric_limits<double>::infinity();  // s
  std::function<std::vector<double>(const Samples&)> evaluate{};
  std::vector<Quantity> quantities{};  // what they are, one of each, for the record
};

/// When a run is sampled.
struct Schedule {
  std::vector<double> times;  // s  rising; all particles are kept at these, and the run ends at the last
  Monitor monitor{};
  std::string name{};  // for the progress line
};

/// What was monitored.
struct History {
  std::vector<double> time;                 // s
  std::vector<std::vector<double>> values;  // one row a time
};

/// What came of one run. A diverged run holds what was sampled before.
struct Run {
  RunSummary summary{};
  std::vector<Samples> samples{};
  History history{};
  std::vector<Value> found{};   // values that the run itself measured, such as a critical time step
  std::vector<Curve> curves{};  // that the run itself drew, of figures that a plot of the case declares
  std::optional<Room> room{};   // of its fluid; none if it is of no simulation

  /// Adds a value that the run itself measured.
  void add(const Quantity& quantity, double value) { found.push_back({"", 0, not_a_number, quantity, value}); }
  /// Such a value; not a number if there is none.
  double value_of(const Quantity& quantity) const {
    const auto named = std::ranges::find(found, quantity, &Value::quantity);
    return named == found.end() ? not_a_number : named->value;
  }

  /// The samples at a time [s], or null. Times agree to half a time step.
  const Samples* at(double time) const {
    for (const Samples& s : samples)
      if (std::abs(s.time - time) <= 0.51 * summary.time_step) return &s;
    return nullptr;
  }
};

/// Runs a simulation to the last time of the schedule. Divergence is a result, not an error: all particles are
/// evaluated every few hundred steps, and a run that has diverged is made again up to the last sound sample, and on
/// step by step, so that what it ends with names the first step and the particle.
Run simulate(const MakeSimulation& make, const Schedule& when, Stepping stepping = Stepping::as_given);

/// What a run says whose step was shortened.
inline const Quantity shortest_step_taken{"shortest time step over the nominal one", ""};

/// A run that is made of many simulations, to find something out: what they cost together, by the meter, the number
/// of their particles and the steps of all.
Run run_of_trials(const CostMeter& meter, long particles, long boundary_particles, long steps);

/// How often a run is evaluated [steps]: each time costs about as much as a step or two.
inline constexpr long steps_between_checks = 500;

}  // namespace touchstone::vnv
