#pragma once
#include "solvers/mpm/affine_nodes.hpp"
#include "solvers/mpm/affine_particles.hpp"
#include "solvers/mpm/lanes.hpp"
#include "solvers/mpm/shapes/quadratic_b_spline.hpp"

namespace touchstone::mpm {

/// Sums over the particles of a cell, per mass of a particle, for one function of X and the three of Y: those of the
/// weights of its nodes, and of their weights times what the particles give to them.
template <class Real>
struct AffineSums {
  template <class Q>
  using OfY = std::array<Q, 3>;
  OfY<Real> mass{}, x{}, y{};

  using Basis = QuadraticBSpline::Basis<Real>;

  /// Adds what particles have whose weight along x is `weight` and whose lever is `lever`.
  void add(const AffineParticles& particles, int slot, const Real& weight, const Real& lever, const Basis& Y) {
    mass[0] += weight;
    mass[1] += weight * Y.xi;
    mass[2] += weight * Y.even;
    add(particles.x, slot, weight, lever, Y, x);
    add(particles.y, slot, weight, lever, Y, y);
  }
  void add(const AffineParticles::Component& component, int slot, const Real& weight, const Real& lever, const Basis& Y,
           OfY<Real>& sums) {
    const Real given = weight * load<Real>(component.v, slot) + lever * load<Real>(component.along_x, slot);
    const Real turned = weight * load<Real>(component.along_y, slot);
    sums[0] += given;
    sums[1] += given * Y.xi + turned;
    sums[2] += given * Y.even + turned * Y.lever;
  }

  /// Totals over the lanes, one share for each function of Y.
  OfY<Share> total() const {
    OfY<Share> shares;
    for (int n = 0; n < 3; ++n) shares[n] = Share(mpm::total(mass[n]), mpm::total(x[n]), mpm::total(y[n]), 0);
    return shares;
  }
};

/// For one function of X; `weight_and_lever(basis)` names it.
template <class Function>
[[gnu::always_inline]] inline std::array<Share, 3> sum_over(const AffineParticles& particles, int begin, int end,
                                                            const Function& function) {
  std::array<Share, 3> shares{Share::Zero(), Share::Zero(), Share::Zero()};
  int slot = begin;
  const auto add = [&]<class Real>(AffineSums<Real>& sums) {
    const QuadraticBSpline::Basis<Real> X(load<Real>(particles.X, slot)), Y(load<Real>(particles.Y, slot));
    const auto [weight, lever] = function(X);
    sums.add(particles, slot, weight, lever, Y);
  };
  if (end - begin >= lanes) {
    AffineSums<Lanes> sums;
    for (; slot + lanes <= end; slot += lanes) add(sums);
    shares = sums.total();
  }
  if (slot < end) {
    AffineSums<double> sums;
    for (; slot < end; ++slot) add(sums);
    const auto rest = sums.total();
    for (int n = 0; n < 3; ++n) shares[n] += rest[n];
  }
  return shares;
}

}  // namespace touchstone::mpm
