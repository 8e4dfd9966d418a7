#pragma once
#include "vnv/record/run_summary.hpp"

#include <chrono>
#include <vector>

namespace touchstone::vnv {

/// Wall time [s] since it was made.
class StopWatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Measures what happens between its construction and `read`: user and wall time.
class CostMeter {
 public:
  CostMeter();
  /// Fills in the times of one run; particles, steps and memory are the caller's.
  Cost read() const;

 private:
  double user_start_;  // s
  StopWatch watch_;
};

/// The cost of a run that was made several times: each time the median, and the span of the CPU times.
Cost cost_of_repeats(const std::vector<Cost>& repeats);

}  // namespace touchstone::vnv
