#pragma once
#include "reference/refuse.hpp"

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

  /// Distance of the front from the back wall [m], at any time: the rarefaction that comes back from the wall lags
  /// behind it, and ever more so, so that the front never learns that the column was finite.
  double operator()(double t) const {
    require_positive("RitterFront", {{"g [m/s²]", g}, {"h0 [m]", h0}, {"l0 [m]", l0}});
    require_time("RitterFront", t);
    return l0 + 2 * std::sqrt(g * h0) * t;
  }
};

}  // namespace touchstone::reference
