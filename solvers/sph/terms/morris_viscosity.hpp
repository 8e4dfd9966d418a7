#pragma once
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

/// Laminar viscosity of Morris, Fox & Zhu (1997), (22), without softening: for particles that are kept apart.
struct MorrisViscosity {
  double mu;  // Pa s

  template <class Real>
  Acceleration<Real> operator()(const Pair<Real>& ij) const {
    const Real c = ij.mass * ij.slope * NumberIn<Real>(2 * mu) * ij.specific_volume_i * ij.specific_volume_j;
    return {c * ij.vx, c * ij.vy};
  }
};

}  // namespace touchstone::sph
