#pragma once
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

/// Viscosity along the line between two particles, 8 mu m / (rho_i rho_j) (v_ij · r_ij) / r² grad W in the plane:
/// Cleary & Monaghan, J. Comput. Phys. 148 (1999), 227-264, with the factor of Monaghan, Rep. Prog. Phys. 68 (2005),
/// section 8.1, 2 (d + 2) in d dimensions. It keeps angular momentum, which `LaminarViscosity` and `MorrisViscosity` do
/// not, and acts on a change of volume too, as a bulk viscosity of 5/3 mu. It wants many neighbours: on a square
/// lattice it is 16.8 % too weak with the quintic spline and h of one spacing, and 0.9 % with Wendland's C2 and three;
/// the other two are then within 1 %.
struct MonaghanClearyViscosity {
  double mu;  // Pa s

  template <class Real>
  Real divisor(const Pair<Real>& ij) const {
    return ij.r2;
  }
  template <class Real>
  Acceleration<Real> acceleration(const Pair<Real>& ij, const Real& per_divisor) const {
    const Real c = ij.mass * ij.slope * NumberIn<Real>(8 * mu) * ij.specific_volume_i * ij.specific_volume_j *
                   ij.v_dot_r() * per_divisor;
    return {c * ij.x, c * ij.y};
  }
  template <class Real>
  Acceleration<Real> operator()(const Pair<Real>& ij) const {
    return acceleration(ij, Real(1 / divisor(ij)));
  }
};

}  // namespace touchstone::sph
