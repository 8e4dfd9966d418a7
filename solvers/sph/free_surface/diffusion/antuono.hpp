#pragma once
#include "solvers/sph/free_surface/surroundings.hpp"

namespace touchstone::sph {

/// Diffusion of density after Antuono, Colagrossi, Marrone & Molteni, Comput. Phys. Commun. 181 (2010), 532-549: that
/// of Molteni & Colagrossi (2009) less what a linear rise of density contributes, by gradients of density that are
/// exact for it at free surfaces too: delta h c sum_j (2 (rho_j - rho_i) r_ji / r² - (grad rho_i + grad rho_j)) · grad
/// W V_j. What is left smooths like a fourth derivative and keeps the sum of V_i drho_i at zero.
struct Antuono {
  static constexpr bool reads_surroundings = true;

  double delta = 0.1;  // -
  double sound_speed;  // m/s
  double h;            // m

  /// What j adds to the rate of rho_i [kg/m³ s].
  template <class Real, class I, class J>
  Real rate(const Pair<Real>& ij, const I& i, const J& j) const {
    using Packed = std::remove_cvref_t<decltype(*j.all)>;
    const auto gradient_i = i.two(&Packed::rho_along_x), gradient_j = j.two(&Packed::rho_along_x);
    const Real linear = (gradient_i[0] + gradient_j[0]) * ij.x + (gradient_i[1] + gradient_j[1]) * ij.y;
    return NumberIn<Real>(delta * h * sound_speed) * ij.mass * ij.specific_volume_j * ij.slope *
           (2 * (ij.rho_i - ij.rho_j) - linear);
  }
};

}  // namespace touchstone::sph
