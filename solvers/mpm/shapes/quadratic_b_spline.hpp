#pragma once
#include "solvers/mpm/shapes/shape_laws.hpp"

namespace touchstone::mpm {

/// The quadratic B-spline on nodes at cell centres (Steffen, Kirby & Berzins 2008), the same in every cell: a place
/// touches three nodes along each direction, those of its cell and of the two beside it, which may be behind a wall.
/// `BSpline<2>` is cut off there.
///
/// `X` runs from 0 to 1 over the cell, slopes are per cell.
struct QuadraticBSpline {
  static constexpr int nodes = 3;  // along each direction
  static constexpr double place(int node) { return node - 0.5; }
  static constexpr double weight(int node, double X) {
    const double xi = X - 0.5;
    return node == 1 ? 0.75 - xi * xi : (node == 0 ? (1 - X) * (1 - X) : X * X) / 2;
  }
  static constexpr double slope(int node, double X) { return node == 1 ? 1 - 2 * X : node == 0 ? X - 1 : X; }
};

static_assert(obeys_shape_laws<QuadraticBSpline>());

}  // namespace touchstone::mpm
