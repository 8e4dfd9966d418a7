#pragma once
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

/// -(P_i / rho_i² + P_j / rho_j²) grad W: the first part of (28). Print has a minus between the two; only the plus
/// keeps momentum (Monaghan 1992).
struct Pressure {
  template <class Real>
  Acceleration<Real> operator()(const Pair<Real>& ij) const {
    const Real c = -(ij.mass * ij.slope) * (ij.p_over_rho2_i + ij.p_over_rho2_j);
    return {c * ij.x, c * ij.y};
  }
};

}  // namespace touchstone::sph
