#pragma once
#include "solvers/sph/common_steps.hpp"

namespace touchstone::sph {

/// Gives each ghost that fluid is near the velocity on the straight line from the mean of that fluid, weighted by the
/// kernel, through the velocity at the wall: exact for a velocity that is linear from the wall on. The pressure is that
/// mean and what the body force adds on the way. A ghost out of reach is at rest, without pressure.
///
/// Fluid that has come closer to the wall than `nearest` [m] is taken for as far from it: else what noise it has would
/// be thrown far beyond the wall (Morris, Fox & Zhu 1997 limit likewise).
///
/// `mirror_to_ghosts` mirrors the mean as if it stood where the ghost's mirror image does.
template <class Kernel, class Packed, class FluidLaw, class Force>
void extrapolate_to_ghosts(Neighbourhood<Packed>& near, const std::vector<Wall>& walls, double h, double nearest,
                           const FluidLaw& fluid, const Force& body_force, double time) {
  const auto terms = [per_h = static_cast<typename Packed::Number>(1 / h)](const auto& g, const auto& j) {
    const auto sides = apart(j, g);
    using Real = std::remove_cvref_t<decltype(sides[0])>;
    const Real r = square_root(Real(sides[0] * sides[0] + sides[1] * sides[1])), weight = Kernel::w(Real(r * per_h));
    const auto v = j.two(&Packed::vx), volume_and_p = j.two(&Packed::specific_volume);
    return std::array<Real, 6>{
        weight, weight * v[0], weight * v[1], weight * volume_and_p[1], weight * sides[0], weight * sides[1]};
  };
  give_to_ghosts<6>(
      near, fluid.density, terms, [&](const BoundaryLayout::Ghost& ghost, const auto& sums, Packed& seen) {
        const Vec2 way(sums[4] / sums[0], sums[5] / sums[0]), from = ghost.x + way;
        Vec2 v(sums[1] / sums[0], sums[2] / sums[0]);
        double p = sums[3] / sums[0];
        for (const int w : ghost.behind) {
          const Wall& wall = walls[w];
          const double away = std::max(wall.distance(from), nearest), ratio = wall.distance(ghost.x) / away;
          const Vec2 at_wall = wall.at_wall(v, time, away);
          v = at_wall + ratio * (v - at_wall);
        }
        if constexpr (is_present<Force>) p -= fluid.density * body_force(from, time).dot(way);
        seen.move(v.x(), v.y());
        seen.set_state(fluid.density_at(p), p);
      });
}

}  // namespace touchstone::sph
