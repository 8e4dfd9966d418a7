#pragma once
#include "solvers/mpm/affine_nodes.hpp"

#include <optional>

namespace touchstone::mpm {

/// Walls and the periodic seam of the affine method. With nodes at cell centres a wall lies midway between a line of
/// nodes in the fluid and a line of ghosts behind it, and every particle beside it has an image behind it.
///
/// What a particle gives to a ghost, its image gives to the node in the fluid: the same mass, and the momentum m v
/// mirrored by the wall's answer, m (2 W(v) - v). A body force and the stress are part of that momentum. The ghost then
/// moves with 2 W(v) - v of that node, so fluid at the wall moves as the wall says. Across the seam the same is done
/// with nothing mirrored.
class Mirrors {
 public:
  /// Throws std::invalid_argument for a wall off the grid.
  Mirrors(const std::vector<Wall>& walls, const Grid& grid) {
    if (grid.periodic_x) {
      lines_.push_back({0, 0, grid.columns, {}});
      lines_.push_back({0, grid.columns + 1, 1, {}});
    }
    for (const Wall& wall : walls) {
      const int line = line_of(wall, grid);
      lines_.push_back({wall.axis, wall.inward > 0 ? line : line + 1, wall.inward > 0 ? line + 1 : line, wall});
    }
  }

  /// Takes what the ghosts were given to the nodes in the fluid, as walls answer at `time` [s].
  void fold(CentreNodes& nodes, double time) const {
    for (const Line& line : lines_)
      line.for_each(nodes, [&](int ghost, int inner) {
        const Share& given = nodes.sums[ghost];
        if (given[0] > Nodes::least_mass) nodes.sums[inner] += line.mirrored(given, time);
      });
  }

  /// Has the ghosts move as the nodes in the fluid have them; a ghost in a corner comes to mirror a ghost.
  void unfold(CentreNodes& nodes, double time) const {
    for (auto line = lines_.rbegin(); line != lines_.rend(); ++line)
      line->for_each(
          nodes, [&](int ghost, int inner) { nodes.velocity[ghost] = line->mirrored(nodes.velocity[inner], time); });
  }

 private:
  /// Counted from the low edge of the grid.
  static int line_of(const Wall& wall, const Grid& grid) {
    const double line = (wall.position - grid.box.low[wall.axis]) / grid.cell[wall.axis];
    const int lines = wall.axis == 0 ? grid.columns : grid.rows;
    if (!(std::abs(line - std::round(line)) < 1e-6 && line > -0.5 && line < lines + 0.5))  // more than rounding leaves
      throw std::invalid_argument(
          fmt::format("mpm: wall at {} = {:g} m, wanted on a grid line: {:g} + 0 to {} times {:g} m",
                      wall.axis == 0 ? "x" : "y", wall.position, grid.box.low[wall.axis], lines, grid.cell[wall.axis]));
    return static_cast<int>(std::round(line));
  }

  struct Line {
    int axis, ghosts, inner;  // node columns (axis 0) or rows (1)
    std::optional<Wall> wall;

    Vec2 mirrored(const Vec2& v, double time) const { return wall ? Vec2(2 * wall->at_wall(v, time) - v) : v; }
    Share mirrored(const Share& given, double time) const {
      const Vec2 v = mirrored(Vec2(given[1] / given[0], given[2] / given[0]), time);
      return {given[0], given[0] * v.x(), given[0] * v.y(), 0};
    }

    template <class F>
    void for_each(const CentreNodes& nodes, const F& f) const {
      if (axis == 1) {
        const Span span = nodes.near(ghosts);
        for (int column = span.begin; column < span.end; ++column) f(nodes.at(column, ghosts), nodes.at(column, inner));
        return;
      }
      for (int row = 0; row < nodes.rows; ++row)
        if (const Span span = nodes.near(row); span.begin <= ghosts && ghosts < span.end)
          f(nodes.at(ghosts, row), nodes.at(inner, row));
    }
  };
  std::vector<Line> lines_;  // in the order in which they are folded
};

}  // namespace touchstone::mpm
