#pragma once
/// The nodes of the affine method: one at the centre of each cell, and a ring of ghosts around them.

#include "solvers/mpm/cell_order.hpp"
#include "solvers/mpm/nodes.hpp"

#include <algorithm>

namespace touchstone::mpm {

/// What particles give to a node, per mass of a particle: mass [particles], momentum along x and y [m/s], nothing.
using Share = Eigen::Array4d;

/// Cells from `begin` to `end` of a row.
struct Span {
  int begin = 0, end = 0;

  bool is_empty() const { return begin == end; }
};
inline Span hull(const Span& a, const Span& b) {
  if (a.is_empty()) return b;
  return b.is_empty() ? a : Span{std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

/// Node columns and rows are numbered from those of the ghosts: the cell (column, row) has its node at (column + 1,
/// row + 1) and touches the nodes (column, row) to (column + 2, row + 2).
///
/// Each row of cells gives to three rows of nodes, and has a place of its own for what it gives to each; a node adds up
/// what it was given in a fixed order, whoever came first. In a row only what lies between the first and the last cell
/// that hold particles is looked at; in a periodic domain the whole row.
class CentreNodes {
 public:
  CentreNodes(const Grid& grid, const CellOrder& order)
      : columns(grid.columns + 2),
        rows(grid.rows + 2),
        sums(columns * rows),
        velocity(columns * rows),
        periodic_(grid.periodic_x),
        occupied_(grid.rows),
        given_(3 * columns * grid.rows) {
    list_occupied(order);
  }

  const int columns, rows;
  std::vector<Share> sums;     // of each node
  std::vector<Vec2> velocity;  // m/s

  int at(int column, int row) const { return row * columns + column; }

  /// Cells of a row of cells to be visited.
  const Span& cells(int cell_row) const { return occupied_[cell_row]; }
  /// Nodes of a row of nodes that are near them.
  Span near(int row) const {
    Span cells;
    for (int cell_row = std::max(row - 2, 0); cell_row <= std::min(row, rows - 3); ++cell_row)
      cells = hull(cells, occupied_[cell_row]);
    return {cells.begin, cells.is_empty() ? cells.end : cells.end + 2};
  }

  /// What a row of cells gives to the node row below, its own or the one above: `towards` 0, 1, 2.
  Share* given(int cell_row, int towards) { return &given_[(3 * cell_row + towards) * columns]; }

  void clear(int cell_row) {
    const Span& span = occupied_[cell_row];
    if (span.is_empty()) return;
    for (int towards : {0, 1, 2})
      std::fill(given(cell_row, towards) + span.begin, given(cell_row, towards) + span.end + 2, Share::Zero());
  }

  /// Adds up what the nodes of a row were given.
  void collect(int row) {
    const Span span = near(row);
    std::fill(&sums[at(span.begin, row)], &sums[at(span.end, row)], Share::Zero());
    for (int towards : {2, 1, 0}) {
      const int cell_row = row - towards;
      if (cell_row < 0 || cell_row >= rows - 2 || occupied_[cell_row].is_empty()) continue;
      const Share* from = given(cell_row, towards);
      for (int column = occupied_[cell_row].begin; column < occupied_[cell_row].end + 2; ++column)
        sums[at(column, row)] += from[column];
    }
  }

  /// Adds a change of velocity [m/s] to all nodes of a row.
  void push(int row, const Vec2& dv) {
    const Span span = near(row);
    const Share per_mass(0, dv.x(), dv.y(), 0);
    for (int node = at(span.begin, row); node < at(span.end, row); ++node) sums[node] += sums[node][0] * per_mass;
  }

  void find_velocities(int row) {
    const Span span = near(row);
    for (int node = at(span.begin, row); node < at(span.end, row); ++node) {
      const Share& sum = sums[node];
      velocity[node] = sum[0] > Nodes::least_mass ? Vec2(sum[1] / sum[0], sum[2] / sum[0]) : Vec2(0, 0);
    }
  }

  void list_occupied(const CellOrder& order) {
    const int cell_columns = columns - 2;
    std::fill(occupied_.begin(), occupied_.end(), Span{});
    for (int cell : order.occupied()) {
      const int column = cell % cell_columns;
      Span& span = occupied_[cell / cell_columns];
      span = periodic_ ? Span{0, cell_columns} : hull(span, {column, column + 1});
    }
  }

 private:
  bool periodic_;
  std::vector<Span> occupied_;  // of each row of cells
  std::vector<Share> given_;
};

}  // namespace touchstone::mpm
