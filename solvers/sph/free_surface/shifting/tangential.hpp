#pragma once
#include "solvers/sph/free_surface/surroundings.hpp"

namespace touchstone::sph {

/// Moves particles from where they are crowded to where they are sparse, along a free surface only where one is near,
/// and not at all on drops and edges of it.
///
/// Lind, Xu, Stansby & Rogers, J. Comput. Phys. 231 (2012), 1499-1523, shift down the gradient of concentration and
/// change velocity and density by what their gradients say; the length of the way and the guard against pairs are those
/// of Sun, Colagrossi, Marrone & Zhang, Comput. Methods Appl. Mech. Engrg. 315 (2017), 25-49:
/// -4 h U dt sum_j (1 + 0.2 (W / W(spacing))⁴) grad W V_j, with U the speed of the fastest particle, and at most U dt /
/// 2. A surface is seen by fullness (Marrone et al. 2010), its normal by how fullness rises.
struct TangentialShifting {
  static constexpr bool reads_surroundings = true;
  static constexpr double surface = 0.75;  // -  fullness: a particle with less is at a surface
  static constexpr double edge = 0.4;      // -  one with less is not shifted

  double spacing;  // m

  /// How much a neighbour counts at q = r / h, the more the closer it is.
  template <class Kernel, class Real>
  Real crowd(const Real& q, double per_h) const {
    const Real close = Kernel::w(q) * Number<Real>(1 / Kernel::w(spacing * per_h)), close2 = close * close;
    return 1 + Number<Real>(0.2) * close2 * close2;
  }

  /// The way of a particle [m] per U dt [m], by its sums of crowd V_j grad W [1/m].
  static Vec2 way(const Vec2& crowd, double h) {
    const Vec2 way = -4 * h * crowd;
    return way * std::min(1.0, 0.5 / std::max(way.norm(), std::numeric_limits<double>::min()));
  }

  /// What is left of a way at a surface: `rise` is the sum of V_j (fullness_j - fullness_i) grad W, along its normal,
  /// and `near_surface` whether a neighbour is at one.
  template <class Packed>
  static Vec2 along_surface(const Vec2& way, const Packed& self, const Vec2& rise, bool near_surface) {
    if (self.fullness < edge) return Vec2::Zero();
    if (!near_surface && self.fullness >= surface) return way;
    const Vec2 n = self.corrected(rise.x(), rise.y()).stableNormalized();
    return way - way.dot(n) * n;
  }
};

}  // namespace touchstone::sph
