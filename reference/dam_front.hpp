#pragma once
#include "reference/refuse.hpp"

#include <fmt/format.h>

#include <cmath>

namespace touchstone::reference {

/// Ritter's dam break: water of depth h0 between a wall at x = 0 and a gate at x = l0, which vanishes at t = 0, runs
/// out over a dry, level, frictionless bed. Ritter, Z. Ver. Deutsch. Ing. 36 (1892), 947-954. This is the inviscid
/// shallow-water limit. The tip has its full speed at once; real water must first turn from falling to running and then
/// drags on the bed, so the limit is an upper bound of the tip speed, dL/dT <= 2 with L = x / l0 and
/// T = t sqrt(g h0) / l0, and not what an experiment should show.
/// Throws std::domain_error unless g, h0 and l0 are positive and t is finite and not negative.
struct RitterFront {
  double g;   // m/s²
  double h0;  // m  depth of the column
  double l0;  // m  its length

  /// Distance of the front from the back wall [m], at any time. The rarefaction comes back from the wall, which it
  /// reaches at l0 / c0, along dx/dt = u + c, with solution x = l0 + 2 c0 t - 3 l0 (c0 t / l0)^(1/3): it lags behind
  /// the front, where u = 2 c0 and c = 0, and ever more so. The front never learns that the column was finite.
  double operator()(double t) const {
    require_time("RitterFront", t);
    return l0 + speed() * t;
  }

  /// Speed of the front [m/s], 2 sqrt(g h0).
  double speed() const {
    require_column();
    return 2 * wave_speed();
  }

  /// Depth [m] at x >= 0 until the rarefaction reaches the back wall; refused for t later than l0 / sqrt(g h0).
  double depth(double x, double t) const {
    require_place_and_time(x, t);
    const double c0 = wave_speed();
    if (x <= l0 - c0 * t) return h0;
    if (x >= l0 + 2 * c0 * t) return 0;
    const double c = (2 * c0 - (x - l0) / t) / 3;  // m/s  the local wave speed, sqrt(g h)
    return c * c / g;
  }

 private:
  static constexpr double rounding = 1e-12;

  double wave_speed() const { return std::sqrt(g * h0); }

  void require_column() const {
    require_positive("RitterFront", "g [m/s²]", g);
    require_positive("RitterFront", "h0 [m]", h0);
    require_positive("RitterFront", "l0 [m]", l0);
  }

  void require_place_and_time(double x, double t) const {
    require_column();
    require_time("RitterFront::depth", t);
    const double last = l0 / wave_speed();
    if (!(t <= (1 + rounding) * last))
      refuse("RitterFront::depth", "t [s]", t, fmt::format("at most {}, when the rarefaction is at the wall", last));
    if (!(std::isfinite(x) && x >= -rounding * l0))
      refuse("RitterFront::depth", "x [m]", x, "a place in front of the wall");
  }
};

}  // namespace touchstone::reference
