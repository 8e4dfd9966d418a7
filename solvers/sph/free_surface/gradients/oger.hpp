#pragma once
#include "solvers/sph/free_surface/surroundings.hpp"

namespace touchstone::sph {

/// The gradient of the kernel times (L_i + L_j) / 2, L as in `BonetLok` and 1 in a wall: made symmetric after Oger,
/// Doring, Alessandrini & Ferrant, J. Comput. Phys. 225 (2007), 1472-1492. A sum of pressures keeps momentum, but not
/// its moment, since a pair's forces do not lie on the line between the two; linear fields are not exact.
struct Oger {
  static constexpr bool looks_around = true;

  template <class Real, class I, class J>
  Pull<Real> operator()(const I& i, const J& j, const Pull<Real>& along) const {
    using Record = std::remove_cvref_t<decltype(*i.all)>;
    const auto xx_xy_i = i.two(&Record::l_xx), xx_xy_j = j.two(&Record::l_xx), yy_i = i.two(&Record::l_yy),
               yy_j = j.two(&Record::l_yy);
    const Number<Real> half = 0.5;
    const Real xx = half * (xx_xy_i[0] + xx_xy_j[0]), xy = half * (xx_xy_i[1] + xx_xy_j[1]),
               yy = half * (yy_i[0] + yy_j[0]);
    return {xx * along.x + xy * along.y, xy * along.x + yy * along.y};
  }
};

}  // namespace touchstone::sph
