#pragma once
/// The background grid, its indices and its periodic boundary.

#include "solvers/scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace touchstone::mpm {

/// Cells that fill the box of a domain exactly. Cells and nodes are numbered row by row from the low corner. Across the
/// boundary of a periodic x the last column of cells has its right corners in the first column of nodes; across that of
/// a periodic y the first row of nodes stands again above the last row of cells.
class Grid {
 public:
  /// Takes the whole number of cells nearest to size / expected along each direction, so that opposite walls both lie
  /// on nodes: 1.61 m in cells of 0.02 m becomes 81 or 80 cells of about 0.02 m, whichever way the half is rounded.
  /// Throws std::invalid_argument if the expected cell [m] is not positive or leaves no cell or too many.
  Grid(const Domain& domain, double expected_cell)
      : Grid(domain.box, domain.periodic_x, domain.periodic_y, cells_along(domain.box.size().x(), expected_cell),
             cells_along(domain.box.size().y(), expected_cell)) {}

  /// Cells of the same size, each around a node of this grid; the outer half of the first and the last along an axis
  /// that is not periodic lies outside.
  Grid around_nodes() const {
    Box around{box.low - cell / 2, box.high - cell / 2};
    const Vec2 more(!periodic_x, !periodic_y);
    around.high += more.cwiseProduct(cell);
    return {around, periodic_x, periodic_y, columns + !periodic_x, rows + !periodic_y};
  }

  const Box box;  // m
  const bool periodic_x, periodic_y;
  const int columns, rows;
  const Vec2 cell;  // m  size of each

  int cells() const { return columns * rows; }
  int nodes() const { return node_columns() * (rows + 1); }
  int node_columns() const { return periodic_x ? columns : columns + 1; }
  int cell_at(int column, int row) const { return row * columns + column; }
  int node_at(int column, int row) const { return row * node_columns() + column % node_columns(); }
  /// Of a place within a cell [m].
  Vec2 place(int the_cell, double X, double Y) const {
    return box.low + Vec2((the_cell % columns + X) * cell.x(), (the_cell / columns + Y) * cell.y());
  }

  Vec2 place_of(int node) const {  // m
    return box.low + cell.cwiseProduct(Vec2(node % node_columns(), node / node_columns()));
  }

  /// The grid line of a wall, counted from the low edge. Throws std::invalid_argument if it stands off the grid, or
  /// only along a part of it.
  int line_of(const Wall& wall) const {
    if (wall.is_partial())
      throw std::invalid_argument(fmt::format("mpm: wall at {} = {:g} m has an extent, expected one across the domain",
                                              wall.axis == 0 ? "x" : "y", wall.position));
    const double line = (wall.position - box.low[wall.axis]) / cell[wall.axis];
    const int lines = wall.axis == 0 ? columns : rows;
    const double off = std::abs(line - std::round(line));
    if (!(off < 1e-6 && line > -0.5 && line < lines + 0.5))  // of a cell; more than rounding leaves
      throw std::invalid_argument(
          fmt::format("mpm: wall at {} = {:g} m, expected on a grid line: {:g} + 0 to {} times {:g} m",
                      wall.axis == 0 ? "x" : "y", wall.position, box.low[wall.axis], lines, cell[wall.axis]));
    return static_cast<int>(std::round(line));
  }

  /// The nodes of a wall. Throws as `line_of`.
  std::vector<int> nodes_on(const Wall& wall) const {
    const int fixed = line_of(wall);
    std::vector<int> found;
    if (wall.axis == 0)
      for (int row = 0; row <= rows; ++row) found.push_back(node_at(fixed, row));
    else
      for (int column = 0; column < node_columns(); ++column) found.push_back(node_at(column, fixed));
    return found;
  }

 private:
  Grid(const Box& its_box, bool along_x, bool along_y, int its_columns, int its_rows)
      : box(its_box),
        periodic_x(along_x),
        periodic_y(along_y),
        columns(its_columns),
        rows(its_rows),
        cell(box.size().x() / columns, box.size().y() / rows) {}

  static int cells_along(double size, double expected) {
    constexpr double most = 20000;  // so that cells and nodes can be counted in an int
    const double n = std::round(size / expected);
    if (!(expected > 0 && n >= 1 && n <= most))
      throw std::invalid_argument(
          fmt::format("mpm: cell = {:g} m, expected positive and 1 to {:g} times in {:g} m", expected, most, size));
    return static_cast<int>(n);
  }
};

}  // namespace touchstone::mpm
