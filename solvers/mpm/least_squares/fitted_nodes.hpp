#pragma once
/// Nodes that know the fluid around them by polynomials of second degree.

#include "solvers/mpm/least_squares/sums.hpp"
#include "solvers/mpm/printed/nodes.hpp"

namespace touchstone::mpm {

/// Where particles are along an axis, as linear hats have it.
struct HatsAlong {
  std::array<Lanes, 3> hat, from;  // of the node before their cell, at it and behind it: weight, and place from there
};

/// The polynomials of nine nodes, by column and row.
using Nine = ThreeByThree<RowsOfCells::Fit::Polynomial>;

/// Those of the corners of a particle's cell, joined by linear hats: exact for the second degree.
inline Lanes joined(const Nine& nodes, const HatsAlong& x, const HatsAlong& y) {
  Lanes sum{};
  for_three([&](auto b) {
    Lanes along_x{};
    for_three([&](auto a) {
      const auto& c = nodes[a][b];
      along_x += x.hat[a] * (c[0] + x.from[a] * (c[1] + x.from[a] * c[3] + y.from[b] * c[4]) +
                             y.from[b] * (c[2] + y.from[b] * c[5]));
    });
    sum += y.hat[b] * along_x;
  });
  return sum;
}

/// A node in the middle of every cell, and a ring of ghosts that continue fields past the edges.
class FittedNodes : public CentreNodes {
 public:
  /// Fields that are fitted: velocity [m/s], and density less that at rest [kg/m³].
  enum FittedField { v_x, v_y, excess };
  static constexpr int fields = RowsOfCells::fields;
  using Around = std::array<Nine, fields>;

  /// Throws std::invalid_argument for fewer than three nodes along an axis.
  FittedNodes(const Grid& cells, int threads)
      : CentreNodes(cells, lanes), grid_(cells), threads_(threads), rows_of_cells_(threads, RowsOfCells(cells)) {
    if (cells.columns < 3 || cells.rows < 3)
      throw std::invalid_argument(
          fmt::format("mpm: {} x {} nodes, expected at least 3 along each axis", cells.columns, cells.rows));
    for (auto& polynomial : fit) polynomial.fill(Field<double>(places()));
    for (const int axis : {0, 1}) {
      const bool periodic = axis == 0 ? cells.periodic_x : cells.periodic_y;
      least_[axis].resize(places());
      most_[axis].assign(places(), 1);
      if (periodic) continue;
      least_[axis][0] = -1;
      most_[axis][(axis == 0 ? cells.columns : cells.rows) - 1] = 0;
    }
  }

  /// Of each field the factors of 1, x, y, x², xy, y² [cells].
  std::array<std::array<Field<double>, 6>, fields> fit;

  int node_at(int column, int row) const { return (row + 1) * stride + column + 1; }
  Vec2 velocity(int node) const { return {fit[v_x][0][node], fit[v_y][0][node]}; }
  void set_velocity(int node, const Vec2& v) {
    fit[v_x][0][node] = v.x();
    fit[v_y][0][node] = v.y();
  }

  /// Calls work(node, column, row) for the first node of every register.
  template <class Work>
  void for_nodes(const Work& work) const {
    share_out(threads_, grid_.rows, [&](Index begin, Index end) {
      for (int row = static_cast<int>(begin); row < end; ++row)
        for (int column = 0; column < grid_.columns; column += lanes) work(node_at(column, row), column, row);
    });
  }

  /// Fits each node to the particles less than one and a half cells away, weighted by the quadratic B-spline. The sums
  /// of a node have one order, whatever the number of threads.
  void fit_to(const FittedParticles& particles, double density) {
    share_out(threads_, threads_, [&](Index begin, Index end) {
      for (Index part = begin; part < end; ++part) {
        RowsOfCells& cells = rows_of_cells_[part];
        const auto first_of = [&](Index of) { return static_cast<int>(grid_.rows * of / threads_); };
        int row = first_of(part);
        cells.sum(particles, density, row - 1);
        cells.sum(particles, density, row);
        for (; row < first_of(part + 1); ++row) {
          cells.sum(particles, density, row + 1);
          fit_row(cells, row);
        }
      }
    });
  }

  /// Continues a field of the nodes to the ghosts: across a periodic boundary by its images, past another edge by what
  /// beyond(first, second, third) makes of the nodes within.
  template <class Beyond>
  void extend(Field<double>& field, const Beyond& beyond) const {
    const auto along = [&](int first, int step, int count, bool periodic) {
      const auto at = [&](int k) -> double& { return field[first + k * step]; };
      at(0) = periodic ? at(count) : beyond(at(1), at(2), at(3));
      at(count + 1) = periodic ? at(1) : beyond(at(count), at(count - 1), at(count - 2));
    };
    for (int row = 1; row <= grid_.rows; ++row) along(row * stride, 1, grid_.columns, grid_.periodic_x);
    for (int column = 0; column < columns; ++column) along(column, stride, grid_.rows, grid_.periodic_y);
  }

  /// Of places X from the node in the middle of their cells, from the column or row `cell` on. Past an edge that is not
  /// periodic the last two nodes go on, and the ghost counts for nothing.
  HatsAlong hats_at(int axis, int cell, const Lanes& X) const {
    const auto limits = [&](const Field<double>& of) {
      return axis == 0 ? load<Lanes>(&of[cell]) : fill<Lanes>(of[cell]);
    };
    const Lanes least = limits(least_[axis]), most = limits(most_[axis]);
    const auto limited = [](const Lanes& low, const Lanes& a, const Lanes& high) -> Lanes {
      const Lanes up = a > low ? a : low;
      return up < high ? up : high;
    };
    const Lanes before = limited(most - 1, -X, least + 1), behind = limited(least, X, most);
    return {{before, 1 - before - behind, behind}, {X + 1, X, X - 1}};
  }
  /// The polynomials around cells of which `node` is the first of the nine.
  Around around(int node) const {
    Around all;
    for_indices<fields>([&](auto f) {
      for_three([&](auto a) {
        for_three([&](auto b) {
          for_indices<6>([&](auto k) { all[f][a][b][k] = load<Lanes>(&fit[f][k][node + b * stride + a]); });
        });
      });
    });
    return all;
  }
  /// The parabolas through the nine nodes around cells, for a field of the nodes.
  PowersOfBoth parabolas(const Field<double>& field, int node) const {
    return laid_out(*this, field, node, [](const Powers& q) {
      return Powers{q[1], 0.5 * (q[2] - q[0]), 0.5 * (q[2] + q[0]) - q[1]};
    });
  }

 private:
  [[gnu::flatten]] void fit_row(const RowsOfCells& cells, int row) {
    for (int at = 0, column = 0; column < grid_.columns; ++at, column += lanes) {
      const auto found = RowsOfCells::Fit::of(cells.of_nodes(row, at));
      for (int f = 0; f < fields; ++f)
        for (int k = 0; k < 6; ++k) store(found[f][k], &fit[f][k][node_at(column, row)]);
    }
    for (auto& polynomial : fit)
      for (auto& factor : polynomial) std::fill(&factor[node_at(grid_.columns, row)], &factor[stride * (row + 2)], 0);
  }

  Grid grid_;
  int threads_;
  std::array<Field<double>, 2> least_, most_;  // cells  towards the node behind, for each column and each row
  std::vector<RowsOfCells> rows_of_cells_;     // of each thread
};

}  // namespace touchstone::mpm
