#pragma once
/// What several methods do alike around their sums over pairs.

#include "solvers/forces/none.hpp"
#include "solvers/sph/momentum.hpp"
#include "solvers/sph/neighbourhood.hpp"
#include "solvers/sph/settings.hpp"
#include "solvers/stepping/laps.hpp"

namespace touchstone::sph {

/// How far the lists of a method reach whose walls push as far as `wall` [m]: with a skin of a tenth of a spacing, or
/// up to so many times that where particles are fast. Throws std::invalid_argument for settings that are not positive.
template <class Kernel>
ListReach reach_of(const Settings& s, double wall = 0, double times = 3) {
  constexpr double skin = 0.1;  // spacings; lists last a hundred steps in a channel, a few in a splash
  return {.kernel = Kernel::support * checked(s).smoothing_length,
          .wall = wall,
          .skin = skin * s.spacing,
          .least_skin = skin * s.spacing,
          .greatest_skin = times * skin * s.spacing};
}

/// Adds the body force per mass, the last part of (24).
template <class Force>
void add_force(const Force& body_force, Particles& all, double time, int threads) {
  share_out_fields(threads, all.fluid, [&, body_force](Index begin, Index end) {
    const double *const x = all.x.data(), *const y = all.y.data();
    double *const ax = all.ax.data(), *const ay = all.ay.data();
    for (Index i = begin; i < end; ++i) {
      const Vec2 force = body_force(Vec2(x[i], y[i]), time);
      ax[i] += force.x();
      ay[i] += force.y();
    }
  });
}

/// Calls give(ghost, sums, seen) for each ghost that fluid is near, with sums of terms(g, j) over that fluid, of which
/// the first is a weight, to write what is seen of it; then its images follow. A ghost out of the kernel's reach, which
/// lists may hold, is at rest at a density without pressure.
template <std::size_t K, class Packed, class Terms, class Give>
void give_to_ghosts(Neighbourhood<Packed>& near, double density, const Terms& terms, const Give& give) {
  sum_over_neighbours<K>(near.fluid_near_ghost, near.seen, terms, [&](Index g, const std::array<double, K>& sums) {
    Packed& seen = near.seen[g];
    if (sums[0] > 0) return give(near.boundary.ghosts[g - near.all.fluid], sums, seen);
    seen.move(0, 0);
    seen.set_state(density, 0);
  });
  near.images.refresh_boundary(near.all, near.seen);
}

/// The rate of density by continuity (23), alone.
template <class Kernel, class Packed>
void find_continuity(Neighbourhood<Packed>& near, double h) {
  Particles& all = near.all;
  sum_over_neighbours<1>(
      near.fluid_near_fluid, near.seen,
      [mass = all.mass, slope = Slope<Kernel>(h)](const auto& i, const auto& j) {
        const auto ij = pair_of(i, j, mass, slope);
        return std::array{ij.continuity()};
      },
      [drho = all.drho.data()](Index i, const std::array<double, 1>& sums) { drho[i] = sums[0]; });
}

/// The rates of velocity by the listed terms (28) and, if asked for, of density by continuity (23), in one pass over
/// the pairs.
template <class Kernel, bool of_density, class Packed, class Terms>
void find_rates_by(const Terms& terms_of_method, Neighbourhood<Packed>& near, double h) {
  Particles& all = near.all;
  sum_over_neighbours<3>(
      near.fluid_near_fluid, near.seen,
      [terms = terms_of_method, mass = all.mass, slope = Slope<Kernel>(h)](const auto& i, const auto& j) {
        auto ij = pair_of(i, j, mass);
        const auto acceleration = terms.on(ij, slope);
        return std::array{ij.continuity(), acceleration.x, acceleration.y};
      },
      [drho = all.drho.data(), ax = all.ax.data(), ay = all.ay.data()](Index i, const std::array<double, 3>& sums) {
        if constexpr (of_density) drho[i] = sums[0];
        ax[i] = sums[1];
        ay[i] = sums[2];
      });
}

}  // namespace touchstone::sph
