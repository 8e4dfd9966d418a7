#pragma once
#include "solvers/sph/free_surface/surroundings.hpp"

namespace touchstone::sph {

/// Moves particles from where they are crowded to where they are sparse, along a free surface only where one is near,
/// and not at all on drops and edges of it.
///
/// Down the gradient of concentration (Lind, Xu, Stansby & Rogers, J. Comput. Phys. 231 (2012), 1499-1523) as far as
/// Sun, Colagrossi, Marrone & Zhang, Comput. Methods Appl. Mech. Engrg. 315 (2017), 25-49, say, with their guard
/// against pairs: -4 h U dt sum_j (1 + 0.2 (W / W(spacing))⁴) grad W V_j, with U the speed of the fastest particle, and
/// at most U dt / 2. As there, and unlike in Lind et al., velocities do not change on the way: what a particle has more
/// than its surroundings is in its own gradient too, by which it would grow (README.md). A surface is seen by the least
/// eigenvalue (Marrone et al. 2010), its normal by the gradient of that.
struct TangentialShifting {
  static constexpr bool reads_surroundings = true;
  static constexpr double surface = 0.75;  // -  least eigenvalue: a particle with less is at a surface
  static constexpr double edge = 0.4;      // -  one with less is not shifted

  double spacing;  // m

  /// How much a neighbour counts at q = r / h, the more the closer it is.
  template <class Kernel, class Real>
  Real concentration_weight(const Real& q, double per_h) const {
    const Real close = Kernel::w(q) * NumberIn<Real>(1 / Kernel::w(spacing * per_h)), close2 = close * close;
    return 1 + NumberIn<Real>(0.2) * close2 * close2;
  }

  /// The displacement of a particle [m] per U dt [m], by the sum of concentration_weight V_j grad W [1/m].
  static Vec2 displacement(const Vec2& concentration_gradient, double h) {
    const Vec2 displacement = -4 * h * concentration_gradient;
    return displacement * std::min(1.0, 0.5 / std::max(displacement.norm(), std::numeric_limits<double>::min()));
  }

  /// What is left of a displacement at a surface: `eigenvalue_gradient` is the sum of V_j (least_eigenvalue_j -
  /// least_eigenvalue_i) grad W, along its normal, and `near_surface` whether a neighbour is at one.
  template <class Packed>
  static Vec2 along_surface(const Vec2& displacement, const Packed& self, const Vec2& eigenvalue_gradient,
                            bool near_surface) {
    if (self.least_eigenvalue < edge) return Vec2::Zero();
    if (!near_surface && self.least_eigenvalue >= surface) return displacement;
    const Vec2 n = self.corrected(eigenvalue_gradient.x(), eigenvalue_gradient.y()).stableNormalized();
    return displacement - displacement.dot(n) * n;
  }
};

}  // namespace touchstone::sph
