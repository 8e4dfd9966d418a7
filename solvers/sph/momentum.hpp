#pragma once
#include "solvers/sph/neighbours.hpp"
#include "solvers/sph/pair.hpp"

#include <tuple>

namespace touchstone::sph {

/// The terms of a method's momentum equation, as types: one that is not listed costs nothing.
template <class... Terms>
struct Momentum {
  std::tuple<Terms...> terms;

  template <class Real>
  Pull<Real> operator()(const Pair<Real>& ij) const {
    Pull<Real> sum;
    std::apply([&](const auto&... term) { ((sum += term(ij)), ...); }, terms);
    return sum;
  }
};

template <class... Terms>
Momentum<Terms...> momentum(const Terms&... terms) {
  return {{terms...}};
}

/// Particles i and their neighbours j, with the slope of the kernel between them.
template <class Kernel, class I, class J>
auto pair_of(const Particles& all, const I& i, const J& j, double h) {
  Pair<typename J::Real> ij;
  ij.x = i(all.x) - j(all.x);
  ij.y = i(all.y) - j(all.y);
  ij.r2 = ij.x * ij.x + ij.y * ij.y;
  const auto r = square_root(ij.r2);
  ij.slope = Kernel::dw(r / h) / (h * h * h * r);
  ij.vx = i(all.vx) - j(all.vx);
  ij.vy = i(all.vy) - j(all.vy);
  ij.rho_i = i(all.rho);
  ij.rho_j = j(all.rho);
  ij.p_i = i(all.p);
  ij.p_j = j(all.p);
  ij.mass = all.mass;
  return ij;
}

/// Adds the body force per mass, the last part of (24).
template <class Force>
void add_force(const Force& body_force, const Particles& all, double time, Scalars& ax, Scalars& ay) {
  for (Index i = 0; i < all.fluid; ++i) {
    const Vec2 force = body_force(Vec2(all.x[i], all.y[i]), time);
    ax[i] += force.x();
    ay[i] += force.y();
  }
}

}  // namespace touchstone::sph
