#pragma once
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

/// Laminar viscosity of Lo & Shao (2002); Sun et al. (26). The softening keeps the quotient finite when particles meet;
/// it also takes eta² / (r² + eta²), about 1.4 % between nearest neighbours, off the viscosity.
struct LaminarViscosity {
  double nu;   // m²/s
  double eta;  // m  0.1 h

  template <class Real>
  Pull<Real> operator()(const Pair<Real>& ij) const {
    const Real c = ij.mass * 4 * nu * ij.r2 * ij.slope / ((ij.rho_i + ij.rho_j) * (ij.r2 + eta * eta));
    return {c * ij.vx, c * ij.vy};
  }
};

}  // namespace touchstone::sph
