#pragma once
/// Shapes as blocks of cells see them, one cell a lane: with(block, work) calls work(along_x, along_y), whose at(X) is
/// what is needed of a place; with_affine(block, work) the same, whose affine_slope(place) is of the affine velocity,
/// too. The shapes are named by the types of `plain`, whose node k along an axis is `first_node` + k here; of nodes
/// that are the same, along a periodic axis, those from `first_of_period` on are no ghosts (`Edges`).

#include "solvers/mpm/lanes/any_weights.hpp"
#include "solvers/mpm/shapes/b_spline.hpp"
#include "solvers/mpm/shapes/gimp.hpp"
#include "solvers/mpm/shapes/linear_hat.hpp"
#include "solvers/mpm/shapes/quadratic_b_spline.hpp"

#include <algorithm>

namespace touchstone::mpm {

/// Moments of the particles of cells, X^m Y^n.
template <int count, class Particles, class Block>
auto moments_of(const Particles& particles, const Block& block) {
  return sums_of_powers<0, count, [](int) { return count; }>(particles, block, one_each);
}

/// Along each axis the cells of a block's lanes; those past the last are taken for it.
struct CellsInLanes {
  int cells;
  bool periodic;
  std::array<int, lanes> cell;

  template <class Block>
  static CellsInLanes along(int axis, const Grid& grid, const Block& block) {
    const int count = axis == 0 ? grid.columns : grid.rows;
    CellsInLanes all{count, axis == 0 ? grid.periodic_x : grid.periodic_y, {}};
    for (int lane = 0; lane < lanes; ++lane)
      all.cell[lane] = axis == 0 ? std::min(block.column + lane, count - 1) : block.row;
    return all;
  }
  /// What number_of(cell) says, in lanes.
  template <class NumberOf>
  Lanes each(const NumberOf& number_of) const {
    Lanes numbers;
    for (int lane = 0; lane < lanes; ++lane) numbers[lane] = number_of(cell[lane]);
    return numbers;
  }
};

/// For shapes whose weights are found at each place.
template <class Along>
class ByWeights {
 public:
  static constexpr int touched = Along::touched, first_node = Along::first_node;
  using Sums = NodesNear<touched>;
  static constexpr int first_of_period = 0;
  static constexpr bool cut_at_edges = false, holds_partial_walls = false;

  ByWeights(const Grid& grid, const Vec2& side) : grid_(grid), reach_(side.cwiseQuotient(2 * grid.cell)) {}

  double reach(int axis) const { return reach_[axis]; }  // cells  half the side of a particle

  template <class Block, class Work>
  void with(const Block& block, const Work& work) const {
    work(Along(CellsInLanes::along(0, grid_, block), reach_.x()),
         Along(CellsInLanes::along(1, grid_, block), reach_.y()));
  }
  template <class Block, class Work>
  void with_affine(const Block& block, const Work& work) const {
    with(block, work);
  }

  /// A field of the nodes near the cells whose first node is `node`.
  static Sums within(const NodesOfCells<touched>& nodes, const Field<double>& field, int node) {
    Sums near;
    for_indices<touched>([&](auto a) {
      for_indices<touched>([&](auto b) { near.of[a][b] = load<Lanes>(&field[node + b * nodes.stride + a]); });
    });
    return near;
  }

  /// How many particles a block gives; and what they give that take a field from the nodes and give it back.
  template <class Particles, class Block>
  Sums mass(const Particles& particles, const Block& block) const {
    Sums sums;
    with(block, [&](const auto& along_x, const auto& along_y) {
      for_particles_of(block, [&](int slot, const auto& write) {
        add(sums, along_x.at(load<Lanes>(&particles.X[slot])), along_y.at(load<Lanes>(&particles.Y[slot])),
            write.present ? fill<Lanes>(1) : Lanes{});
      });
    });
    return sums;
  }
  struct Moments {};
  template <class Particles, class Block>
  static Moments moments(const Particles&, const Block&) {
    return {};
  }
  template <class Particles, class Block>
  Sums mass(const Moments&, const Particles& particles, const Block& block) const {
    return mass(particles, block);
  }
  template <class Particles, class Block>
  Sums there_and_back(const Sums& field, const Moments&, const Particles& particles, const Block& block) const {
    Sums sums;
    with(block, [&](const auto& along_x, const auto& along_y) {
      for_particles_of(block, [&](int slot, const auto& write) {
        const auto X = along_x.at(load<Lanes>(&particles.X[slot])), Y = along_y.at(load<Lanes>(&particles.Y[slot]));
        add(sums, X, Y, write.present ? value_at(field, X, Y) : Lanes{});
      });
    });
    return sums;
  }

 private:
  Grid grid_;
  Vec2 reach_;
};

/// B-splines of a degree by the recurrence of de Boor and Cox, with the knots of each lane's cell, as `BSpline`.
template <int degree>
class BSplineAlong {
 public:
  static constexpr int touched = degree + 1, first_node = 0;

  BSplineAlong(const CellsInLanes& cells, double /*reach*/) {
    for (int k = 1 - degree; k <= degree; ++k)
      knots_[k + degree - 1] = cells.each(
          [&](int cell) -> double { return cells.periodic ? k : std::clamp(cell + k, 0, cells.cells) - cell; });
    for (int d = 1; d <= degree; ++d)
      for (int a = 1; a <= d; ++a) per_length_[d - 1][a - 1] = 1 / (knot(a) - knot(a - d));
    for (int a = 0; a <= degree; ++a) {
      for (int k = a - degree + 1; k <= a; ++k) places_[a] += knot(k);
      places_[a] /= degree;
    }
  }

  static auto affine_slope(const WeightsAlong<touched>& at) { return at.affine_slope(); }
  WeightsAlong<touched> at(const Lanes& X) const {
    WeightsAlong<touched> found;
    AlongNodes<touched> lower{{fill<Lanes>(1)}};  // splines of the degree below
    for_indices<degree>([&](auto below) {
      constexpr int d = below + 1;
      AlongNodes<touched> raised{};
      for_indices<d>([&](auto k) {
        constexpr int a = k + 1;
        const Lanes share = per_length_[below][k] * lower[k];
        raised[a] += (X - knot(a - d)) * share;
        raised[k] += (knot(a) - X) * share;
        if constexpr (d == degree) {
          found.slopes[a] += degree * share;
          found.slopes[k] -= degree * share;
        }
      });
      lower = raised;
    });
    found.weights = lower;
    for_indices<touched>([&](auto a) { found.arms[a] = places_[a] - X; });
    return found;
  }

 private:
  const Lanes& knot(int k) const { return knots_[k + degree - 1]; }  // cells  from the low edge of the cell

  std::array<Lanes, 2 * degree> knots_;
  std::array<std::array<Lanes, degree>, degree> per_length_{};  // of the pieces of which splines are raised
  AlongNodes<touched> places_{};                                // cells  of the nodes
};

/// Generalised interpolation, as `Gimp`: hats, but where a particle reaches over its cell's edge by r it has a weight
/// of r² / (2 side) at the next node, too, which those within the cell make up for, since weights add up to one and
/// their arms to nothing. Not so at an edge of the domain that is no periodic boundary.
class GimpAlong {
 public:
  static constexpr int touched = 4, first_node = 1;

  GimpAlong(const CellsInLanes& cells, double reach)
      : reach_(fill<Lanes>(reach)),
        below_(cells.each([&](int cell) { return !cells.periodic && cell == 0 ? 0 : 1 / (2 * reach); })),
        above_(cells.each([&](int cell) { return !cells.periodic && cell == cells.cells - 1 ? 0 : 1 / (2 * reach); })) {
  }

  static auto affine_slope(const WeightsAlong<touched>& at) { return at.affine_slope(); }
  WeightsAlong<touched> at(const Lanes& X) const {
    const Lanes over_low = positive(reach_ - X), over_high = positive(reach_ - (1 - X)), low = below_ * over_low,
                high = above_ * over_high, w_low = 0.5 * low * over_low, w_high = 0.5 * high * over_high;
    return {.weights = {{w_low, 1 - X - 2 * w_low + w_high, X + w_low - 2 * w_high, w_high}},
            .slopes = {{-low, -1 + 2 * low + high, 1 - low - 2 * high, high}},
            .arms = {{-1 - X, -X, 1 - X, 2 - X}}};
  }

 private:
  static Lanes positive(const Lanes& x) { return x > 0 ? x : Lanes{}; }

  Lanes reach_;          // cells
  Lanes below_, above_;  // 1/cells  over the side, or 0 at an edge
};

template <int degree>
BSplineAlong<degree> in_lanes_along(BSpline<degree>);
BSplineAlong<1> in_lanes_along(LinearHat);
GimpAlong in_lanes_along(Gimp);

template <class Shape>
class ShapeInLanes : public ByWeights<decltype(in_lanes_along(Shape{}))> {
 public:
  using ShapeInLanes::ByWeights::ByWeights;
};

/// Quadratic B-splines are polynomials in each cell, whole ones everywhere: what is cut off at edges is handled at the
/// nodes there (`Edges`). Only affine slopes know edges.
template <>
class ShapeInLanes<BSpline<2>> {
 public:
  static constexpr int touched = 3, first_node = 0, first_of_period = 1;
  static constexpr bool cut_at_edges = true, holds_partial_walls = true;
  using Sums = PowersOfBoth;

  ShapeInLanes(const Grid& grid, const Vec2& /*side*/) : grid_(grid) {}

  static double reach(int /*axis*/) { return 0; }

  template <class Block, class Work>
  void with(const Block&, const Work& work) const {
    work(WholeSplines{}, WholeSplines{});
  }
  template <class Block, class Work>
  void with_affine(const Block& block, const Work& work) const {
    with_splines(grid_, block, work);
  }

  static Sums within(const CentreNodes& nodes, const Field<double>& field, int node) {
    return laid_out(nodes, field, node);
  }

  template <class Particles, class Block>
  static Sums mass(const Particles& particles, const Block& block) {
    return moments_of<3>(particles, block);
  }
  /// Nodes to particles and back again is, within each cell, a matrix of moments of its particles.
  using Moments = Square<Lanes, 5>;
  template <class Particles, class Block>
  static Moments moments(const Particles& particles, const Block& block) {
    return moments_of<5>(particles, block);
  }
  template <class Particles, class Block>
  static Sums mass(const Moments& moments, const Particles&, const Block&) {
    Sums mass;
    for_three([&](auto i) { for_three([&](auto k) { mass[i][k] = moments[i][k]; }); });
    return mass;
  }
  /// Sums over the particles of q X^i Y^k, for a field q.
  template <class Particles, class Block>
  static Sums there_and_back(const Sums& q, const Moments& moments, const Particles&, const Block&) {
    Sums sums{};
    for_three([&](auto i) {
      for_three([&](auto k) {
        for_three([&](auto a) { for_three([&](auto b) { sums[i][k] += moments[i + a][k + b] * q[a][b]; }); });
      });
    });
    return sums;
  }

 private:
  Grid grid_;
};
/// The same that are whole up to walls, which mirror what is behind them (`LaneWalls<QuadraticBSpline>`).
template <>
class ShapeInLanes<QuadraticBSpline> : public ShapeInLanes<BSpline<2>> {
 public:
  static constexpr bool cut_at_edges = false;
  using ShapeInLanes<BSpline<2>>::ShapeInLanes;

  template <class Block, class Work>
  static void with_affine(const Block&, const Work& work) {
    work(WholeSplines{}, WholeSplines{});
  }
};

}  // namespace touchstone::mpm
