#pragma once
/// Shapes along one axis of the grid, from edge to edge. In the plane a weight is the product of those along both axes.

#include "solvers/mpm/shapes/shape_laws.hpp"

#include <array>

namespace touchstone::mpm {

/// An axis of the grid as a shape sees it.
struct GridAxis {
  int cells;
  bool periodic;
  double reach;  // cells  half the side of a particle
};

/// The nodes that a place on an axis touches: `first` and those that follow, counted on across a periodic boundary.
template <int width_>
struct NearNodes {
  static constexpr int width = width_;
  int first = 0;
  std::array<double, width> weight{};
  std::array<double, width> slope{};  // per cell
  std::array<double, width> arm{};    // cells  from the place to the node
};

/// By how much each node tells in the affine slope [per cell], w_a (x_a - x) / D with the spread D = sum w_a (x_a - x)²
/// (Jiang et al. 2015; where weights are products the matrix D is diagonal). Where one node carries all the weight D
/// vanishes, and what this tends to is the slope of the weights.
template <int width>
constexpr std::array<double, width> affine_slopes_of(const NearNodes<width>& near) {
  constexpr double least_spread = 1e-12;  // cells²
  double spread = 0;
  for (int a = 0; a < width; ++a) spread += near.weight[a] * near.arm[a] * near.arm[a];
  if (!(spread > least_spread)) return near.slope;
  std::array<double, width> slopes{};
  for (int a = 0; a < width; ++a) slopes[a] = near.weight[a] * near.arm[a] / spread;
  return slopes;
}

/// The whole number at or below x.
constexpr int floor_of(double x) {
  const int towards_zero = static_cast<int>(x);
  return towards_zero > x ? towards_zero - 1 : towards_zero;
}

/// The cell of a place on an axis: one of its cells, or any where the axis is periodic. Edges belong to the cell above.
constexpr int cell_at(double x, const GridAxis& axis) {
  const int cell = floor_of(x);
  if (axis.periodic) return cell;
  return cell < 0 ? 0 : cell < axis.cells ? cell : axis.cells - 1;
}

/// A shape that is the same in every cell, with nodes where cells meet, such as `LinearHat`.
template <class Shape>
class SameInEveryCell {
 public:
  static constexpr int width = Shape::nodes;
  static_assert(Shape::place(0) == 0 && Shape::place(width - 1) == width - 1);

  constexpr explicit SameInEveryCell(const GridAxis& axis) : axis_(axis) {}

  constexpr int nodes() const { return axis_.periodic ? axis_.cells : axis_.cells + 1; }
  constexpr double place(int node) const { return node; }  // cells  from the low edge
  constexpr NearNodes<width> near(double x) const {
    NearNodes<width> found;
    found.first = cell_at(x, axis_);
    const double X = x - found.first;
    for (int a = 0; a < width; ++a) {
      found.weight[a] = Shape::weight(a, X);
      found.slope[a] = Shape::slope(a, X);
      found.arm[a] = Shape::place(a) - X;
    }
    return found;
  }

 private:
  GridAxis axis_;
};

/// How a shape lies along an axis: as it says itself, or the same in every cell.
template <class Shape>
struct LaidAlong {
  using type = SameInEveryCell<Shape>;
};
template <class Shape>
requires requires { typename Shape::Along; }
struct LaidAlong<Shape> {
  using type = typename Shape::Along;
};
template <class Shape>
using AlongAxis = typename LaidAlong<Shape>::type;

/// Everywhere on an axis, and at edges that are no periodic boundary, where a wall that holds the last node holds the
/// fluid.
template <class Shape>
constexpr ShapeErrors errors_along(const GridAxis& axis) {
  const AlongAxis<Shape> along(axis);
  ShapeErrors errors;
  constexpr int places_per_cell = 16;
  for (int k = 0; k <= places_per_cell * axis.cells; ++k) {
    const auto near = along.near(static_cast<double>(k) / places_per_cell);
    errors.add(near.weight, near.slope, near.arm);
  }
  const auto low = along.near(0), high = along.near(axis.cells);
  errors.edges = !axis.periodic && !(low.first == 0 && low.weight[0] == 1 && high.first + high.width == along.nodes() &&
                                     high.weight[high.width - 1] == 1);
  return errors;
}

/// Closes the header of a shape that differs from cell to cell, for the axis that `axis` gives.
template <class Shape, class Met, class GivesAxis>
consteval bool obeys_laws_along(GivesAxis axis) {
  return are_met<Met>([axis] { return errors_along<Shape>(axis()); });
}

}  // namespace touchstone::mpm
