#pragma once
#include "reference/refuse.hpp"

#include <cmath>
#include <numbers>

namespace touchstone::reference {

/// A decaying shear wave: v_x(y, t) [m/s] = U sin(k y) exp(-nu k² t) with k = 2 pi / L, in a fluid without bounds. It
/// solves the whole equations of motion, since it carries no momentum along its own velocity.
/// Throws std::domain_error unless L and nu are positive, U and y finite, and t finite and not negative.
struct ShearWave {
  double L;   // m     length of the wave
  double U;   // m/s   at the start
  double nu;  // m²/s  kinematic viscosity

  double operator()(double y, double t) const {
    require_positive("ShearWave", {{"L [m]", L}, {"nu [m²/s]", nu}});
    require_finite("ShearWave", {{"U [m/s]", U}, {"y [m]", y}});
    require_time("ShearWave", t);
    return U * std::sin(k() * y) * std::exp(-decay_rate() * t);
  }

  /// How fast it falls [1/s].
  double decay_rate() const { return nu * k() * k(); }

 private:
  double k() const { return 2 * std::numbers::pi / L; }
};

}  // namespace touchstone::reference
