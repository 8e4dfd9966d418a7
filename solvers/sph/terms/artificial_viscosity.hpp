#pragma once
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

/// Artificial viscosity of Monaghan (1992) between particles that close in; Sun et al. (27).
struct ArtificialViscosity {
  double alpha;        // -
  double sound_speed;  // m/s
  double h;            // m

  template <class Real>
  Pull<Real> operator()(const Pair<Real>& ij) const {
    const Real closing = -positive_part(Real(-ij.approach()));
    const double eta2 = 0.01 * h * h;  // keeps r² from zero (27)
    const Real c =
        ij.mass * alpha * sound_speed * h * closing * 2 * ij.slope / ((ij.rho_i + ij.rho_j) * (ij.r2 + eta2));
    return {c * ij.x, c * ij.y};
  }
};

}  // namespace touchstone::sph
