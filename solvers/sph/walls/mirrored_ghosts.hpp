#pragma once
#include "solvers/sph/common_steps.hpp"

namespace touchstone::sph {

/// Gives each ghost that fluid is near the mean of that fluid, weighted by volume and kernel, and mirrors its velocity
/// at the walls it is behind. A ghost out of reach is at rest, at the density of fluid without pressure.
template <class Kernel, class Packed>
void mirror_to_ghosts(Neighbourhood<Packed>& near, const std::vector<Wall>& walls, double h, double density,
                      double time) {
  const auto terms = [per_h = static_cast<typename Packed::Number>(1 / h)](const auto& g, const auto& j) {
    const auto r = distance(g, j);
    using Real = std::remove_cvref_t<decltype(r)>;
    const auto v = j.two(&Packed::vx), volume_and_p = j.two(&Packed::specific_volume);
    const Real rho = j.two(&Packed::rho)[0], weight = volume_and_p[0] * Kernel::w(Real(r * per_h));
    return std::array<Real, 5>{weight, weight * v[0], weight * v[1], weight * rho, weight * volume_and_p[1]};
  };
  give_to_ghosts<5>(near, density, terms, [&](const BoundaryLayout::Ghost& ghost, const auto& sums, Packed& seen) {
    const double per = 1 / sums[0];
    Vec2 v(sums[1] * per, sums[2] * per);
    for (const int w : ghost.behind) v = 2 * walls[w].at_wall(v, time, -walls[w].distance(ghost.x)) - v;
    seen.move(v.x(), v.y());
    seen.set_state(sums[3] * per, sums[4] * per);
  });
}

}  // namespace touchstone::sph
