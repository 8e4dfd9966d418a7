#pragma once
#include "solvers/sph/free_surface/surroundings.hpp"

namespace touchstone::sph {

/// -(1 / rho_i) grad P as -sum_j m_j (P_i L_i + P_j L_j) / (rho_i rho_j) grad W, what continuity with the gradient of
/// `BonetLok` gives back when energy is kept (Bonet & Lok, Comput. Methods Appl. Mech. Engrg. 180 (1999), 97-115).
/// Momentum and its moment are kept, though a pair's forces do not lie on the line between the two, since the corrected
/// gradient sees no strain in a rigid motion; and free surfaces are right without detecting them. A sum does not
/// vanish for a uniform pressure.
struct BonetLokPressure {
  static constexpr bool reads_surroundings = true;

  template <class Real, class I, class J>
  Acceleration<Real> operator()(const Pair<Real>& ij, const I& i, const J& j) const {
    using Packed = std::remove_cvref_t<decltype(*i.all)>;
    const auto xx_xy_i = i.two(&Packed::l_xx), xx_xy_j = j.two(&Packed::l_xx), yy_i = i.two(&Packed::l_yy),
               yy_j = j.two(&Packed::l_yy);
    const Real xx = ij.p_i * xx_xy_i[0] + ij.p_j * xx_xy_j[0], xy = ij.p_i * xx_xy_i[1] + ij.p_j * xx_xy_j[1],
               yy = ij.p_i * yy_i[0] + ij.p_j * yy_j[0],
               c = -(ij.mass * ij.slope) * ij.specific_volume_i * ij.specific_volume_j;
    return {c * (xx * ij.x + xy * ij.y), c * (xy * ij.x + yy * ij.y)};
  }
};

}  // namespace touchstone::sph
