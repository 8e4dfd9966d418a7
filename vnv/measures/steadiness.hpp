#pragma once
/// How steady a flow has become.

#include "vnv/measures/decay.hpp"

#include <algorithm>
#include <iterator>

namespace touchstone::vnv {

/// "rate of change of kinetic energy [%/s]" at the end of each run: the slope of the line through the logs of the
/// energies that were monitored in `column`, over its last `span` [s]. Nothing is reported of a run that diverged.
inline const Quantity change_of_energy{"rate of change of kinetic energy", "%/s", Kind::error};
inline std::vector<Value> unsteadiness_of(const Run& run, std::size_t column, double span) {
  if (!run.summary.finished) return {};
  std::vector<double> times, energies;
  for (std::size_t k = 0; k < run.history.time.size(); ++k)
    if (run.history.time[k] >= run.summary.end_time - span * (1 + 1e-9)) {
      times.push_back(run.history.time[k]);
      energies.push_back(run.history.values[k][column]);
    }
  return {{run.summary.level, run.summary.spacing, run.summary.end_time, change_of_energy,
           100 * std::abs(rate_of_decay(times, energies))}};
}
inline Finding unsteadiness(std::size_t column, double span) {
  return [=](const Results& results, const Record&) {
    std::vector<Value> found;
    for (const Run& run : results.runs)
      std::ranges::copy(unsteadiness_of(run, column, span), std::back_inserter(found));
    return found;
  };
}

}  // namespace touchstone::vnv
