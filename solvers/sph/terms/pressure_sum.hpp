#pragma once
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

/// -(1 / rho_i) grad P as -sum_j m_j (P_i + P_j) / (rho_i rho_j) grad W: what continuity with volumes gives back when
/// energy is kept, right at a free surface without detecting it (Colagrossi & Landrini, J. Comput. Phys. 191 (2003),
/// 448-475).
struct PressureSum {
  template <class Real>
  Acceleration<Real> operator()(const Pair<Real>& ij) const {
    const Real c = -(ij.mass * ij.slope) * (ij.p_i + ij.p_j) * ij.specific_volume_i * ij.specific_volume_j;
    return {c * ij.x, c * ij.y};
  }
};

}  // namespace touchstone::sph
