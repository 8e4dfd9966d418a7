#include "vnv/stability/critical_step.hpp"

#include "solvers/stepping/diverged.hpp"
#include "vnv/record/record.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

/// The highest speed of all particles [m/s], in the frame of the search; infinite if one is no number.
double highest_speed(const Simulation& simulation, const StepSearch& search) {
  const Vectors v = simulation.samples().v.colwise() - search.carried;
  return v.allFinite() ? v.colwise().norm().maxCoeff() : INFINITY;
}

/// Slope of y over its index, by least squares.
double slope_of(const std::vector<double>& y) {
  const auto n = static_cast<double>(y.size());
  double up = 0, down = 0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    const double x = static_cast<double>(k) - (n - 1) / 2;
    up += x * y[k];
    down += x * x;
  }
  return up / down;
}

}  // namespace

bool is_stable(Simulation simulation, const StepSearch& search, long& steps) {
  try {
    for (long k = 0; k < search.steps; ++k) {
      simulation.step();
      ++steps;
      if (k % 50 == 49 && !(highest_speed(simulation, search) < search.speed_limit)) return false;
    }
    return true;
  } catch (const Diverged&) {
    return false;
  }
}

CriticalStep critical_step(const SolverWith& solver_with, const StepSearch& search) {
  CriticalStep bracket{search.low, search.high};
  if (!is_stable(solver_with(search.low), search, bracket.steps))
    throw std::invalid_argument(
        fmt::format("critical step: {} s is unstable, expected a stable lower end", search.low));
  if (is_stable(solver_with(search.high), search, bracket.steps))
    throw std::invalid_argument(
        fmt::format("critical step: {} s is stable, expected an unstable upper end", search.high));
  while (bracket.high > bracket.low * (1 + search.tolerance)) {
    const double middle = std::sqrt(bracket.low * bracket.high);
    (is_stable(solver_with(middle), search, bracket.steps) ? bracket.low : bracket.high) = middle;
  }
  return bracket;
}

double largest_step(const SolverWith& solver_with, const StepSearch& search) {
  long steps = 0;
  if (is_stable(solver_with(search.high), search, steps)) return search.high;
  if (!is_stable(solver_with(search.low), search, steps)) return not_a_number;
  return critical_step(solver_with, search).low;
}

double growth_per_step(Simulation simulation, const StepSearch& search) {
  std::vector<double> logarithms;
  try {
    for (long k = 0; k < search.steps; ++k) {
      simulation.step();
      const double speed = highest_speed(simulation, search);
      if (!std::isfinite(speed)) break;
      logarithms.push_back(std::log(speed));
      if (speed > search.speed_limit) break;
    }
  } catch (const Diverged&) {
  }
  const double limit = std::log(search.speed_limit);
  if (logarithms.size() < 6 || logarithms.back() < limit) return not_a_number;
  const double from = logarithms.front() + (limit - logarithms.front()) / 3;
  std::erase_if(logarithms, [&](double at) { return at < from || at > limit; });
  return logarithms.size() < 4 ? not_a_number : std::exp(slope_of(logarithms));
}

Run search_critical_step(const SolverWith& solver_with, const StepSearch& search, double length, double sound_speed) {
  const CostMeter meter;
  const CriticalStep found = critical_step(solver_with, search);
  const double growth = growth_per_step(solver_with(1.05 * found.high), search);
  const Simulation simulation = solver_with(found.low);
  Run run = run_of_trials(meter, simulation.particles(), simulation.boundary_particles(), found.steps);
  run.summary.time_step = found.low;
  run.add(stable_end, found.low / us);
  run.add(unstable_end, found.high / us);
  run.add(over_courant, found.low * sound_speed / length);
  if (std::isfinite(growth)) run.add(growth_beyond, growth);  // not of one that has blown up within a few steps
  return run;
}

Plot limits_table(std::string title, std::string caption, std::string levels, std::vector<LimitColumn> columns) {
  return [=](const Results& results, Record& record) {
    Table table{"limits", title, caption, {"method", levels}, {}};
    for (const LimitColumn& column : columns) table.columns.push_back(column.heading);
    for (const Run& run : results.runs) {
      std::vector<Cell> row = {results.method.name, run.summary.level};
      for (const LimitColumn& column : columns) {
        const double value = run.value_of(column.quantity);
        row.push_back(std::isnan(value) ? Cell("–") : Cell(value));  // a growth too fast to be measured, say
      }
      table.rows.push_back(std::move(row));
    }
    record.tables.push_back(std::move(table));
  };
}

}  // namespace touchstone::vnv
