#pragma once
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

/// Artificial viscosity of Monaghan (1992) between particles that close in; Sun et al. (27).
struct ArtificialViscosity {
  double alpha;        // -
  double sound_speed;  // m/s
  double h;            // m

  template <class Real>
  Real divisor(const Pair<Real>& ij) const {
    const double eta2 = 0.01 * h * h;  // keeps r² from zero (27)
    return (ij.rho_i + ij.rho_j) * (ij.r2 + NumberIn<Real>(eta2));
  }
  template <class Real>
  Acceleration<Real> acceleration(const Pair<Real>& ij, const Real& per_divisor) const {
    const Real closing = negative_part(ij.v_dot_r());
    const Real c = ij.mass * ij.slope * NumberIn<Real>(2 * alpha * sound_speed * h) * closing * per_divisor;
    return {c * ij.x, c * ij.y};
  }
  template <class Real>
  Acceleration<Real> operator()(const Pair<Real>& ij) const {
    return acceleration(ij, Real(1 / divisor(ij)));
  }
};

}  // namespace touchstone::sph
