#pragma once
#include "solvers/sph/free_surface/surroundings.hpp"

namespace touchstone::sph {

/// The gradient of the kernel times L_i, the inverse of sum_j V_j (r_j - r_i) grad W (Bonet & Lok, Comput. Methods
/// Appl. Mech. Engrg. 180 (1999), 97-115): sums of differences are exact for linear fields, however the particles
/// stand, at a free surface too. What a pair feels is then not opposite: momentum is not kept.
struct BonetLok {
  static constexpr bool reads_surroundings = true;

  template <class Real, class I, class J>
  Acceleration<Real> operator()(const I& i, const J&, const Acceleration<Real>& along) const {
    using Packed = std::remove_cvref_t<decltype(*i.all)>;
    const auto xx_xy = i.two(&Packed::l_xx);
    const Real yy = i.two(&Packed::l_yy)[0];
    return {xx_xy[0] * along.x + xx_xy[1] * along.y, xx_xy[1] * along.x + yy * along.y};
  }
};

}  // namespace touchstone::sph
