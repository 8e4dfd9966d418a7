#pragma once
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

/// -(1 / rho_i) grad P as -sum_j m_j (P_j - P_i) / (rho_i rho_j) grad W: no force in a uniform pressure, whatever the
/// order of the particles (Monaghan 1992, (3.1)).
struct PressureDifference {
  template <class Real>
  Acceleration<Real> operator()(const Pair<Real>& ij) const {
    const Real c = ij.mass * ij.slope * (ij.p_i - ij.p_j) * ij.specific_volume_i * ij.specific_volume_j;
    return {c * ij.x, c * ij.y};
  }
};

}  // namespace touchstone::sph
