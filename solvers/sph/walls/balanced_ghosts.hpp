#pragma once
#include "solvers/sph/common_steps.hpp"

namespace touchstone::sph {

/// Gives each ghost that fluid is near the pressure that holds this fluid where it is: its mean, weighted by the
/// kernel, and what its weight adds on the way; density by that pressure; and the mean velocity, mirrored at the walls
/// it is behind. Adami, Hu & Adams, J. Comput. Phys. 231 (2012), 7057-7075, (23) and (27), for walls that do not
/// accelerate. Exact for water at rest of one density, in corners and beside a free surface too. A ghost out of reach
/// is at rest, without pressure.
///
/// Fluid that splashes needs the mirror, whose velocity is never larger than that of the fluid: the straight line of
/// `extrapolate_to_ghosts` is steep for a drop close to the wall.
template <class Kernel, class Packed, class FluidLaw, class Force>
void balance_ghosts(Neighbourhood<Packed>& near, const std::vector<Wall>& walls, double h, const FluidLaw& fluid,
                    const Force& body_force, double time) {
  const auto terms = [per_h = static_cast<typename Packed::Number>(1 / h)](const auto& g, const auto& j) {
    const auto sides = apart(g, j);
    using Real = std::remove_cvref_t<decltype(sides[0])>;
    const Real r = square_root(Real(sides[0] * sides[0] + sides[1] * sides[1])), weight = Kernel::w(Real(r * per_h));
    const auto v = j.two(&Packed::vx), rho_and_p_over_rho2 = j.two(&Packed::rho),
               volume_and_p = j.two(&Packed::specific_volume);
    const Real heavy = weight * rho_and_p_over_rho2[0];
    return std::array<Real, 6>{weight,           weight * v[0],   weight * v[1], weight * volume_and_p[1],
                               heavy * sides[0], heavy * sides[1]};
  };
  give_to_ghosts<6>(near, fluid.density, terms,
                    [&](const BoundaryLayout::Ghost& ghost, const auto& sums, Packed& seen) {
                      const double per = 1 / sums[0];
                      Vec2 v(per * sums[1], per * sums[2]);
                      for (const int w : ghost.behind)
                        v = 2 * walls[w].at_wall(v, time, -walls[w].distance(ghost.x)) - v;
                      double p = per * sums[3];
                      if constexpr (is_present<Force>) p += per * body_force(ghost.x, time).dot(Vec2(sums[4], sums[5]));
                      seen.move(v.x(), v.y());
                      seen.set_state(fluid.density_at(p), p);
                    });
}

}  // namespace touchstone::sph
