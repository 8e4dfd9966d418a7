#pragma once
/// What a particle knows of its surroundings: how the density rises around it, what makes the gradient of its kernel
/// exact, and how full of particles its kernel is. Found by a pass of its own, before the rates that use it.

#include "solvers/sph/flow.hpp"

namespace touchstone::sph {

template <class Number>
struct Surroundings : Packed<Number> {
  Number rho_along_x = 0, rho_along_y = 0;  // kg/m⁴
  Number l_xx = 1, l_xy = 0;                // -  L, which makes the gradient of a linear field exact; symmetric
  Number l_yy = 1, fullness = 1;            // -  the least eigenvalue of the inverse of L

  /// Takes the sums of V_j (r_j - r_i) grad W, symmetric, whose inverse is L, and of V_j (rho_j - rho_i) grad W.
  /// Eigenvalues below 0.2, of splashes, tips and corners, count as that: L does not jump, and what it corrects there
  /// is too small, never too large. In the very corner of a square it is 0.09, on a straight surface 0.5.
  void set_surroundings(const std::array<double, 3>& moments, const std::array<double, 2>& rise) {
    constexpr double least = 0.2;
    const auto [xx, xy, yy] = moments;
    const double middle = (xx + yy) / 2, apart = std::hypot((xx - yy) / 2, xy), low = middle - apart,
                 high = middle + apart;
    const double per_low = 1 / std::max(low, least), per_high = 1 / std::max(high, least);
    const double per_both = high > low ? (per_high - per_low) / (high - low) : 0, even = per_high - per_both * high;
    l_xx = static_cast<Number>(even + per_both * xx);  // both matrices have the same axes
    l_xy = static_cast<Number>(per_both * xy);
    l_yy = static_cast<Number>(even + per_both * yy);
    fullness = static_cast<Number>(low);
    const Vec2 along = corrected({rise[0], rise[1]});
    rho_along_x = static_cast<Number>(along.x());
    rho_along_y = static_cast<Number>(along.y());
  }

  /// L times a sum of differences times grad W.
  Vec2 corrected(const Vec2& plain) const {
    return {l_xx * plain.x() + l_xy * plain.y(), l_xy * plain.x() + l_yy * plain.y()};
  }
};

/// A part of a method that says `reads_surroundings` reads what this pass finds.
template <class Part>
concept ReadsSurroundings = Part::reads_surroundings;

/// Finds the surroundings of the fluid, of which its ghosts are a part.
template <class Kernel, class Packed>
void find_surroundings(Neighbourhood<Packed>& near, double h) {
  sum_over_neighbours<5>(
      near.fluid_near_fluid, near.seen,
      [mass = near.all.mass, slope = Slope<Kernel>(h)](const auto& i, const auto& j) {
        const auto ij = pair_of(i, j, mass, slope);
        const auto per_r = ij.mass * ij.volume_j * ij.slope;
        const auto x = per_r * ij.x, y = per_r * ij.y, rise = ij.rho_j - ij.rho_i;
        return std::array{-x * ij.x, -x * ij.y, -y * ij.y, rise * x, rise * y};
      },
      [&](Index i, const std::array<double, 5>& sums) {
        near.seen[i].set_surroundings({sums[0], sums[1], sums[2]}, {sums[3], sums[4]});
      });
  near.images.refresh_fluid(near.all, near.seen);
}

/// Gives each ghost that fluid is near the mean rise of density in that fluid.
template <class Kernel, class Packed>
void carry_rise_to_ghosts(Neighbourhood<Packed>& near, double h) {
  const auto terms = [per_h = static_cast<typename Packed::Number>(1 / h)](const auto& g, const auto& j) {
    const auto r = distance(g, j);
    using Real = std::remove_cvref_t<decltype(r)>;
    const Real weight = Kernel::w(Real(r * per_h));
    const auto along = j.two(&Packed::rho_along_x);
    return std::array<Real, 3>{weight, weight * along[0], weight * along[1]};
  };
  sum_over_neighbours<3>(near.fluid_near_ghost, near.seen, terms, [&](Index g, const std::array<double, 3>& sums) {
    const double per = sums[0] > 0 ? 1 / sums[0] : 0;  // what the lists hold may be beyond the kernel
    near.seen[g].rho_along_x = static_cast<typename Packed::Number>(per * sums[1]);
    near.seen[g].rho_along_y = static_cast<typename Packed::Number>(per * sums[2]);
  });
  near.images.refresh_boundary(near.all, near.seen);
}

}  // namespace touchstone::sph
