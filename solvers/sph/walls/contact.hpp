#pragma once
/// Contact of particles with walls, which lets none through.
///
/// Ghosts hold the mean over a kernel still at the wall, not each particle. Where fluid spreads along a wall the row
/// next to it sinks at an even speed, in pressures that balance, and is through after half a spacing.

#include "solvers/sph/particles.hpp"
#include "solvers/walls/contacts.hpp"

namespace touchstone::sph {

/// How near to a wall particles may come or start [spacings]. Fluid at rest stands at half a spacing.
inline constexpr double contact_distance = 0.1;

/// Takes from velocities [m/s] what would carry particles nearer to a wall than `least` [m] in `dt` [s]: a contact that
/// is unilateral, inelastic and without friction (Moreau 1988), which neither pulls nor pushes out. Calls
/// held(particle, normal, before, after) for each that it holds, with its velocity along the normal.
template <class Held>
void keep_off_walls(const Particles& all, Scalars& vx, Scalars& vy, const std::vector<Wall>& walls, double least,
                    double time, double dt, const Held& held) {
  for (const Wall& wall : walls) {
    const Scalars& x = wall.axis == 0 ? all.x : all.y;
    Scalars& v = wall.axis == 0 ? vx : vy;
    for (Index i = 0; i < all.fluid; ++i) {
      const double distance = wall.inward * (x[i] - wall.position), before = wall.inward * v[i],
                   way = std::min(least - distance, 0.0);  // m  the farthest towards the wall
      if (!(dt * before < way)) continue;
      if (wall.is_partial() && (distance < 0 || !wall.is_beside({all.x[i], all.y[i]}, time))) continue;
      const double after = way / dt;
      v[i] = wall.inward * after;
      held(i, wall.normal(), before, after);
    }
  }
}

}  // namespace touchstone::sph
