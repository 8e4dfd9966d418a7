#pragma once
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

/// -(V_i² + V_j²) / m times the density-weighted mean pressure, times grad W (Adami, Hu & Adams 2013, (5) and (8)).
/// Both particles have the same mass, V = m / rho.
struct SharedPressure {
  template <class Real>
  Pull<Real> operator()(const Pair<Real>& ij) const {
    const Real shared = (ij.rho_j * ij.p_i + ij.rho_i * ij.p_j) / (ij.rho_i + ij.rho_j);
    const Real volumes = ij.mass * (1 / (ij.rho_i * ij.rho_i) + 1 / (ij.rho_j * ij.rho_j));
    const Real c = -volumes * shared * ij.slope;
    return {c * ij.x, c * ij.y};
  }
};

}  // namespace touchstone::sph
