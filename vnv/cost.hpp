#pragma once
#include "vnv/record.hpp"

#include <chrono>

namespace touchstone::vnv {

/// Measures what happens between its construction and `read`: CPU and wall time, and the largest resident memory of the
/// process in between (where the system keeps that account; else since the process began).
class CostMeter {
 public:
  CostMeter();
  /// Fills in times and memory; particles and steps are the caller's.
  Cost read() const;

 private:
  double cpu_start_;  // s
  std::chrono::steady_clock::time_point wall_start_;
};

}  // namespace touchstone::vnv
