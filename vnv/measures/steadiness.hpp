#pragma once
/// How steady a flow has become.

#include "vnv/measures/decay.hpp"

namespace touchstone::vnv {

/// "rate of change of kinetic energy [%/s]" at the end of each run: the slope of the line through the logs of the
/// energies that were monitored in `column`, over its last `span` [s]. Nothing is reported of a run that diverged.
inline const Quantity change_of_energy{"rate of change of kinetic energy", "%/s", Kind::error};
inline Finding unsteadiness(std::size_t column, double span) {
  return [=](const Results& results, const Record&) {
    std::vector<Value> found;
    for (const Run& run : results.runs) {
      if (!run.summary.finished) continue;
      std::vector<double> times, energies;
      for (std::size_t k = 0; k < run.history.time.size(); ++k)
        if (run.history.time[k] >= run.summary.end_time - span * (1 + 1e-9)) {
          times.push_back(run.history.time[k]);
          energies.push_back(run.history.seen[k][column]);
        }
      found.push_back({run.summary.level, run.summary.spacing, run.summary.end_time, change_of_energy,
                       100 * std::abs(rate_of_decay(times, energies))});
    }
    return found;
  };
}

}  // namespace touchstone::vnv
