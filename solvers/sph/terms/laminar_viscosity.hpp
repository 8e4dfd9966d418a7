#pragma once
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

/// Laminar viscosity of Lo & Shao (2002); Sun et al. (26). The softening keeps the quotient finite when particles meet;
/// it also takes eta² / (r² + eta²), about 1.4 % between nearest neighbours, off the viscosity.
struct LaminarViscosity {
  double nu;   // m²/s
  double eta;  // m  0.1 h

  template <class Real>
  Real divisor(const Pair<Real>& ij) const {
    return (ij.rho_i + ij.rho_j) * (ij.r2 + NumberIn<Real>(eta * eta));
  }
  template <class Real>
  Acceleration<Real> acceleration(const Pair<Real>& ij, const Real& per_divisor) const {
    const Real c = ij.mass * ij.slope * NumberIn<Real>(4 * nu) * ij.r2 * per_divisor;
    return {c * ij.vx, c * ij.vy};
  }
  template <class Real>
  Acceleration<Real> operator()(const Pair<Real>& ij) const {
    return acceleration(ij, Real(1 / divisor(ij)));
  }
};

}  // namespace touchstone::sph
