#pragma once
/// What flows between two plates share apart from any method: what a user sets of them, what may be wrong, and what is
/// measured and claimed of any code.

#include "vnv/flows/channels/channel.hpp"
#include "vnv/flows/flow.hpp"

#include <numbers>

namespace touchstone::vnv::flows {

/// The velocity along the plates with the lower one at y = 0, of a channel in which something is wrong.
using Altered = std::function<Truth(const Changes&)>;

/// A channel as a user sets it: the gap and the fluid in it, those of Sun et al. (table 1) where nothing is set.
struct Plates {
  Box gap;
  Newtonian fluid;

  explicit Plates(Settings& set);

  double H() const { return gap.high.y(); }                   // m
  double nu() const { return fluid.kinematic_viscosity(); }  // m²/s
  /// Plates do not meet, whatever a fit tries.
  double H(const Changes& by) const;
  double nu(const Changes& by) const { return nu() * by.factor(Cause::viscosity); }

  /// What `walls` says of walls further out, of plates with these velocities [m/s]; of a fluid that slips the exact
  /// flow.
  Altered slipping(const Altered& walls, const std::function<double(const Changes&)>& F, double lower,
                   double upper) const;

  /// The flow between two plates whose velocity along them is `exact`, from its state at t = 0 on. `slips`: `altered`
  /// knows of a fluid that slips.
  Flow flow(std::string title, std::string description, std::vector<double> times, WallVelocity floor,
            WallVelocity ceiling, const Altered& altered, std::vector<Cause> causes, bool slips = false) const;

  /// Times at which a flow is sampled [s]: fractions of that in which viscosity crosses the gap.
  std::vector<double> times(const std::vector<double>& fractions) const;
};

inline const std::vector<Cause> of_two_plates{Cause::viscosity, Cause::floor, Cause::ceiling, Cause::walls,
                                              Cause::slip},
    of_two_plates_and_force{Cause::viscosity, Cause::floor, Cause::ceiling, Cause::walls, Cause::slip, Cause::force},
    of_one_plate{Cause::viscosity, Cause::floor, Cause::slip};

/// Both of an oracle's, seen from the lower and from the upper plate: both plates move alike.
Truth of_both(const Truth& upper, double H);

Instead instead(std::string cause, std::string sentence, const Truth& truth);
/// A plate along which a fluid slips freely is the middle of a channel twice as high.
Instead slips_along(const std::string& wall, const Truth& truth);
Instead is_steady(const Truth& truth);

/// Flows of the paper are judged by the means of their rows, too.
Flow with_row_means(Flow flow, const Altered& altered);

/// What oscillates as cos(omega t), by the period that a user sets; sampled a quarter and three quarters through it.
struct Oscillation {
  double period;  // s

  Oscillation(Settings& set, double published, const std::string& words)
      : period(set.positive("period", published, "s", words)) {}
  double omega() const { return 2 * std::numbers::pi / period; }  // 1/s
  std::vector<double> times() const { return {period / 4, 3 * period / 4}; }
};

}  // namespace touchstone::vnv::flows
