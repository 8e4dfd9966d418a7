#pragma once
/// Where the time of a solver's steps goes.

#include "solvers/stepping/laps.hpp"

#include <array>
#include <chrono>

namespace touchstone::vnv {

/// Adds up the time of each sub-step over those steps that it times; one in `every`, so that reading the clock costs
/// nothing that could be seen: some eight readings of 30 ns a timed step.
class LapClock {
 public:
  explicit LapClock(long every = 1) : every_(every) {}

  /// A step of a solver, timed if it is its turn.
  template <class Solver>
  void step(Solver& solver) {
    if (steps_++ % every_ != 0) return solver.step();
    ++timed_;
    Time last = std::chrono::steady_clock::now();
    solver.step([&](SubStep part) {
      const Time now = std::chrono::steady_clock::now();
      seconds_[static_cast<std::size_t>(part)] += std::chrono::duration<double>(now - last).count();
      last = now;
    });
  }

  /// Mean over the timed steps [s]; zero for what the solver does not do.
  double per_step(SubStep part) const {
    return timed_ == 0 ? 0 : seconds_[static_cast<std::size_t>(part)] / static_cast<double>(timed_);
  }
  double per_step() const {
    double all = 0;
    for (const double part : seconds_) all += part;
    return timed_ == 0 ? 0 : all / static_cast<double>(timed_);
  }

 private:
  using Time = std::chrono::steady_clock::time_point;

  long every_, steps_ = 0, timed_ = 0;
  std::array<double, names_of_sub_steps.size()> seconds_{};
};

}  // namespace touchstone::vnv
