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
  static constexpr double surface = 0.75;  // -  fullness: a particle with less is at a surface
  static constexpr double edge = 0.4;      // -  one with less is not shifted

  /// Shifts the fluid, whose surroundings have been found, as far as in a time `dt` [s].
  template <class Kernel, class Packed>
  void shift(Neighbourhood<Packed>& near, double h, double spacing, double dt) const {
    Particles& all = near.all;
    const double fastest = std::sqrt((all.vx.square() + all.vy.square()).maxCoeff());
    sum_over_neighbours<9>(
        near.fluid_near_fluid, near.seen,
        [mass = all.mass, slope = Slope<Kernel>(h), per_h = 1 / h, per_w = 1 / Kernel::w(spacing / h)](const auto& i,
                                                                                                       const auto& j) {
          const auto ij = pair_of(i, j, mass, slope);
          using Real = std::remove_cvref_t<decltype(ij.r)>;
          const Real w = Kernel::w(Real(ij.r * Number<Real>(per_h))), close = w * Number<Real>(per_w),
                     close2 = close * close;
          const Real per_r = ij.mass * ij.volume_j * ij.slope, x = per_r * ij.x, y = per_r * ij.y;
          const Real crowd = 1 + Number<Real>(0.2) * close2 * close2;
          const Real fullness_i = i.two(&Packed::l_yy)[1], fullness_j = j.two(&Packed::l_yy)[1],
                     fuller = fullness_j - fullness_i;
          return std::array<Real, 9>{crowd * x,
                                     crowd * y,
                                     fuller * x,
                                     fuller * y,
                                     w * positive_part(Real(Number<Real>(surface) - fullness_j)),
                                     -ij.vx * x,
                                     -ij.vx * y,
                                     -ij.vy * x,
                                     -ij.vy * y};
        },
        [&](Index i, const std::array<double, 9>& sums) {
          const Packed& self = near.seen[i];
          if (self.fullness < edge) return;
          Vec2 way = -4 * h * fastest * dt * Vec2(sums[0], sums[1]);
          way *= std::min(1.0, fastest * dt / 2 / std::max(way.norm(), std::numeric_limits<double>::min()));
          if (sums[4] > 0 || self.fullness < surface) {
            const Vec2 n = self.corrected({sums[2], sums[3]}).stableNormalized();
            way -= way.dot(n) * n;
          }
          all.x[i] += way.x();
          all.y[i] += way.y();
          all.vx[i] += self.corrected({sums[5], sums[6]}).dot(way);
          all.vy[i] += self.corrected({sums[7], sums[8]}).dot(way);
          all.rho[i] += Vec2(self.rho_along_x, self.rho_along_y).dot(way);
        });
  }
};

}  // namespace touchstone::sph
