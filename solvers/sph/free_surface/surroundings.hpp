#pragma once
/// What a particle knows of its surroundings: the gradient of density, what makes the gradient of its kernel exact, and
/// by its least eigenvalue how full of particles its kernel is. Found on the way, in the passes that sum the rates.

#include "solvers/sph/common_steps.hpp"

#include <numbers>

namespace touchstone::sph {

/// Least eigenvalues of fluid are cut off at the first; that of a ghost is larger by 1/2, its part in the mean of two
/// gradients (`sum_by_motion`), by which it is told from fluid.
inline constexpr double greatest_fluid_eigenvalue = 1.5, ghost_eigenvalue = greatest_fluid_eigenvalue + 0.5;

template <class Number>
struct Surroundings : Packed<Number> {
  Number rho_along_x = 0, rho_along_y = 0;  // kg/m⁴
  Number l_xx = 1, l_xy = 0;                // -  L, which makes the gradient of a linear field exact; symmetric
  Number l_yy = 1, least_eigenvalue = 1;    // -  of the inverse of L: how full the kernel is

  /// Takes the sum of V_j (r_j - r_i) grad W, symmetric, whose inverse is L. Eigenvalues below 0.4, of splashes, tips
  /// and corners, count as that: L does not jump, and what it corrects there is too small, never too large. In the very
  /// corner of a square it is 0.09, on a straight surface 0.5.
  void set_surroundings(double xx, double xy, double yy) {
    invert(xx, xy, yy, [](double eigenvalue) { return std::max(eigenvalue, least_taken); });
  }
  void set_density_gradient(double along_x, double along_y) {
    rho_along_x = static_cast<Number>(along_x);
    rho_along_y = static_cast<Number>(along_y);
  }

  /// L times a sum of differences times grad W.
  Vec2 corrected(double of_x, double of_y) const { return {l_xx * of_x + l_xy * of_y, l_xy * of_x + l_yy * of_y}; }

 protected:
  static constexpr double least_taken = 0.4;

  /// `taken(eigenvalue)` is what an eigenvalue counts as.
  template <class Taken>
  void invert(double xx, double xy, double yy, const Taken& taken) {
    const double middle = (xx + yy) / 2, apart = std::sqrt((xx - yy) * (xx - yy) / 4 + xy * xy), low = middle - apart,
                 high = middle + apart;
    const double per_low = 1 / taken(low), per_high = 1 / taken(high);
    const double per_both = high > low ? (per_high - per_low) / (high - low) : 0, even = per_high - per_both * high;
    l_xx = static_cast<Number>(even + per_both * xx);  // both matrices have the same axes
    l_xy = static_cast<Number>(per_both * xy);
    l_yy = static_cast<Number>(even + per_both * yy);
    least_eigenvalue = static_cast<Number>(std::min(low, greatest_fluid_eigenvalue));
  }
};

/// The same where pressure pulls by L, and a ghost is told from fluid by its least eigenvalue.
template <class Number>
struct SurroundingsWithGhosts : Surroundings<Number> {
  constexpr SurroundingsWithGhosts() { this->least_eigenvalue = static_cast<Number>(ghost_eigenvalue); }

  using Surroundings<Number>::set_surroundings;
  /// Below 0.4 eigenvalues count as ever more, from 0.1 on as 1, so that drops are no stiffer than without correction:
  /// by stiffer ones the time step adds energy (README.md). Of a pair or a row of particles the least is 0.
  ///
  /// `extent` is the mean square distance to the neighbours over that in full surroundings. A drop of radius of
  /// gyration R whose gradient is exact oscillates at 2 c / R, too fast for time steps by the smoothing length where
  /// many particles have come close: L is smaller there.
  void set_surroundings(double xx, double xy, double yy, double extent) {
    this->invert(xx, xy, yy, [](double eigenvalue) {
      constexpr double some = Surroundings<Number>::least_taken, none = 0.1;
      return std::max(eigenvalue, std::lerp(1.0, some, std::clamp((eigenvalue - none) / (some - none), 0.0, 1.0)));
    });
    const auto share = static_cast<Number>(std::min(extent / least_extent, 1.0));
    this->l_xx *= share;
    this->l_xy *= share;
    this->l_yy *= share;
  }

 private:
  static constexpr double least_extent = 0.7;
};

static_assert(SurroundingsWithGhosts<double>{}.vx == 0);  // a constant has no undefined field

/// The mean square distance to neighbours, the particle itself among them, over that in full surroundings, where it is
/// 1 / (pi W(0)): from the sum of their moments, sum_j V_j r |W'|, and that of their weights, sum_j V_j |W'| / r.
template <class Kernel>
double extent(double moments, double weights, double h) {
  return moments / weights * std::numbers::pi * Kernel::w(0.0) / (h * h);
}

/// A part of a method that says `reads_surroundings` reads what these passes find.
template <class Part>
concept ReadsSurroundings = Part::reads_surroundings;

/// Gives each ghost that fluid is near the mean gradient of density in that fluid.
template <class Kernel, class Packed>
void extrapolate_density_gradient_to_ghosts(Neighbourhood<Packed>& near, double h) {
  const auto terms = [per_h = static_cast<typename Packed::Number>(1 / h)](const auto& g, const auto& j) {
    const auto r = distance(g, j);
    using Real = std::remove_cvref_t<decltype(r)>;
    const Real weight = Kernel::w(Real(r * per_h));
    const auto along = j.two(&Packed::rho_along_x);
    return std::array<Real, 3>{weight, weight * along[0], weight * along[1]};
  };
  sum_over_neighbours<3>(near.fluid_near_ghost, near.seen, terms, [&](Index g, const std::array<double, 3>& sums) {
    const double per = sums[0] > 0 ? 1 / sums[0] : 0;  // what the lists hold may be beyond the kernel
    near.seen[g].set_density_gradient(per * sums[1], per * sums[2]);
  });
  near.images.refresh_boundary(near.all, near.seen);
}

/// Packs the gradient of density of the fluid, which two of its carried fields hold from `first` on; for its ghosts
/// too.
template <class Kernel, class Packed>
void see_density_gradient(Neighbourhood<Packed>& near, std::size_t first, double h) {
  const Particles& all = near.all;
  for (Index i = 0; i < all.fluid; ++i)
    near.seen[i].set_density_gradient(all.carried[first][i], all.carried[first + 1][i]);
  near.images.refresh_fluid(all, near.seen);
  extrapolate_density_gradient_to_ghosts<Kernel>(near, h);
}

}  // namespace touchstone::sph
