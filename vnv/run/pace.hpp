#pragma once
/// How the time step of a run follows its flow.

#include "vnv/run/simulation.hpp"

#include <cmath>

namespace touchstone::vnv {

/// Who says how long a step is.
enum class Stepping {
  as_given,  // the scene: each as long as the simulation was made with
  adaptive,  // the flow, from what it was made with downwards
};

/// A method's own step leaves room for a flow that is livelier than the fluid at rest for which it was chosen: it is at
/// most 0.62 of the longest that lasts there (`critical_step_lattice`), or 0.69 of affine MPM under gravity
/// (`critical_step_water`), and signals may become 1.4 times as fast as sound at rest before it is shortened. So no
/// step exceeds 0.87 of the largest stable one, or 0.97: that is inversely proportional to the speed of signals. Limits
/// by viscosity and body force do not change in a run of one fluid; a particle's acceleration bounds a step less than
/// sound does in any flow that is slightly compressible.
///
/// A few particles, as many as stand in the corners of a cavity, where the flow is singular and densities with it, do
/// not carry waves: what counts is the speed that no more than one particle in a hundred exceeds. Were the step too
/// long for them, what it does there would spread, and count.
///
/// The step is shortened by fifths of itself, so that it changes seldom: a method of several steps starts anew.
class Pace {
 public:
  static constexpr double outliers = 0.01;  // of all particles
  static constexpr double margin = 1.4;     // speeds of sound at rest
  static constexpr double factor = 0.8;     // from one step to the next shorter one
  static constexpr double shortest = 0.1;   // of the given step; a fluid that wants less is not slightly compressible

  /// Of a simulation as it was made.
  explicit Pace(const Simulation& simulation)
      : given_(simulation.time_step()), sound_speed_(simulation.medium().sound_speed) {}

  double given() const { return given_; }  // s

  /// The longest step [s] for the simulation as it is.
  double longest(const Simulation& simulation) const {
    const double fastest = simulation.fastest_signal();
    return longest(fastest <= margin * sound_speed_ ? fastest : simulation.signal_speed(outliers));
  }
  /// The longest step [s] for signals that travel so fast [m/s]; the shortest if that is not a number.
  double longest(double signal_speed) const {
    double share = 1;
    while (share > shortest && !(signal_speed * share <= margin * sound_speed_)) share *= factor;
    return given_ * std::max(share, shortest);
  }

 private:
  double given_, sound_speed_;
};

/// A step that was changed, for whoever makes the run again.
struct StepChange {
  long after;        // steps
  double time_step;  // s
};

}  // namespace touchstone::vnv
