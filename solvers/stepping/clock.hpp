#pragma once
/// The time of a simulation.

#include "solvers/lattice.hpp"

namespace touchstone {

/// Counts steps, whose length its owner's caller may change between two of them. As long as nobody does, the time is
/// the number of steps times their length, without the rounding of a sum.
class Clock {
 public:
  double time() const { return since_ + static_cast<double>(steps_ - steps_then_) * time_step_; }  // s
  long steps() const { return steps_; }
  double time_step() const { return time_step_; }  // s

  /// The length [s] of the steps to come. Throws std::invalid_argument unless it is positive.
  void change_time_step(double time_step) {
    require_positive("clock", "time step [s]", time_step);
    since_ = time();
    steps_then_ = steps_;
    time_step_ = time_step;
  }

 protected:
  /// Throws std::invalid_argument, naming the method, unless the step [s] is positive.
  Clock(std::string_view method, double time_step) : time_step_(time_step) {
    require_positive(method, "time step [s]", time_step);
  }
  void tick() { ++steps_; }

 private:
  double time_step_, since_ = 0;  // s; when the steps got this length
  long steps_ = 0, steps_then_ = 0;
};

}  // namespace touchstone
