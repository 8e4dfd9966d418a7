#pragma once
#include "solvers/sph/pair.hpp"

namespace touchstone::sph {

/// Diffusion of density after Molteni & Colagrossi, Comput. Phys. Commun. 180 (2009), 861-872, in the form of Antuono
/// et al. (2010): delta h c sum_j 2 (rho_j - rho_i) r_ji / r² · grad W V_j. It smooths the noise of pressure and keeps
/// the sum of V_i drho_i at zero. Near a free surface it acts on a density that only rises linearly with depth, too:
/// water at rest slowly expands there.
struct MolteniColagrossi {
  double delta = 0.1;  // -
  double sound_speed;  // m/s
  double h;            // m

  /// What j adds to the rate of rho_i [kg/m³ s].
  template <class Real, class I, class J>
  Real rate(const Pair<Real>& ij, const I&, const J&) const {
    return Number<Real>(2 * delta * h * sound_speed) * ij.mass * ij.volume_j * ij.slope * (ij.rho_i - ij.rho_j);
  }
};

}  // namespace touchstone::sph
