#pragma once
#include "solvers/mpm/shapes/shape_laws.hpp"

#include <array>

namespace touchstone::mpm {

/// The quadratic B-spline on nodes at cell centres (Steffen, Kirby & Berzins 2008): a place in a cell touches three
/// nodes along each direction, those of its cell and of the two beside it.
///
/// `X` runs from 0 to 1 over the cell, slopes are per cell. With xi = X - 1/2 the weights are combinations of 1, xi and
/// xi² + 1/4, and so are the levers 4 w_a (a - xi), by which the affine method turns and stretches, of 0, 1 and
/// xi (3 - 4 xi²); `at_nodes` and `Along` spell them out, so that a cell is summed over its particles first and meets
/// its nodes once.
struct QuadraticBSpline {
  static constexpr int nodes = 3;  // along each direction
  static constexpr double place(int node) { return node - 0.5; }
  static constexpr double weight(int node, double X) {
    const double xi = X - 0.5;
    return node == 1 ? 0.75 - xi * xi : (node == 0 ? (1 - X) * (1 - X) : X * X) / 2;
  }
  static constexpr double slope(int node, double X) { return node == 1 ? 1 - 2 * X : node == 0 ? X - 1 : X; }

  /// How far the weights reach: sum w_a (x_a - x)², in cells², wherever x lies in the cell (Jiang et al. 2015).
  static constexpr double spread = 0.25;

  /// A field along one direction within a cell, made of what it is at the three nodes.
  template <class Q>
  struct Along {
    Q one, xi, even;

    constexpr Along(const Q& left, const Q& here, const Q& right)
        : one(here), xi(0.5 * (right - left)), even(0.5 * (left + right) - here) {}
  };

  /// The functions of a place along one direction of which weights and levers are made.
  template <class Real>
  struct Basis {
    Real xi, even, lever;

    constexpr explicit Basis(const Real& X) : xi(X - 0.5), even(xi * xi + 0.25), lever(xi * (3 - 4 * (xi * xi))) {}

    /// sum q_a w_a.
    constexpr Real of(const Along<Real>& q) const { return q.one + xi * q.xi + even * q.even; }
    /// The affine slope of q per cell: 4 sum q_a w_a (a - xi).
    constexpr Real slope_of(const Along<Real>& q) const { return q.xi + lever * q.even; }
  };

  /// Sums of the functions from those of 1, X and X².
  template <class Q>
  static constexpr std::array<Q, 3> of_powers(const Q& one, const Q& X, const Q& XX) {
    return {one, X - 0.5 * one, XX - X + 0.5 * one};
  }

  /// Sums of q w_a over particles for the three nodes, from those of q, q xi and q (xi² + 1/4); of 4 q w_a (a - xi)
  /// from those of 0, q and q lever.
  template <class Q>
  static constexpr std::array<Q, 3> at_nodes(const Q& one, const Q& xi, const Q& even) {
    return {0.5 * (even - xi), one - even, 0.5 * (even + xi)};
  }
};

/// True if sums at the nodes, fields, levers and spread are those of the weights.
constexpr bool nodes_follow_the_weights() {
  for (double X : {0.0, 0.125, 0.625, 1.0}) {  // dyadic: all is exact
    const QuadraticBSpline::Basis<double> at(X);
    const auto weights = QuadraticBSpline::at_nodes(1.0, at.xi, at.even);
    const auto levers = QuadraticBSpline::at_nodes(0.0, 1.0, at.lever);
    double spread = 0;
    for (int node = 0; node < 3; ++node) {
      const double w = QuadraticBSpline::weight(node, X), arm = QuadraticBSpline::place(node) - X;
      const QuadraticBSpline::Along<double> hat(node == 0, node == 1, node == 2);
      if (weights[node] != w || levers[node] != 4 * w * arm) return false;
      if (at.of(hat) != w) return false;
      if (at.slope_of(hat) != 4 * w * arm) return false;
      spread += w * arm * arm;
    }
    const auto powers = QuadraticBSpline::of_powers(1.0, X, X * X);
    if (powers[0] != 1 || powers[1] != at.xi || powers[2] != at.even) return false;
    if (spread != QuadraticBSpline::spread) return false;
  }
  return true;
}

static_assert(obeys_shape_laws<QuadraticBSpline>());
static_assert(nodes_follow_the_weights());

}  // namespace touchstone::mpm
