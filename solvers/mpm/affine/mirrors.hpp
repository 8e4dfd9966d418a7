#pragma once
#include "solvers/mpm/affine/nodes.hpp"

#include <optional>
#include <utility>

namespace touchstone::mpm {

/// Walls and the periodic boundaries of the affine method. With nodes at cell centres a wall lies midway between a line
/// of nodes in the fluid and a line of ghosts behind it, and every particle beside it has an image behind it.
///
/// What a particle gives to a ghost, its image gives to the node in the fluid: the same mass, and the momentum m v
/// mirrored by the wall's answer, m (2 W(v) - v). Body force and stress are parts of that momentum: at a wall with free
/// slip this is exact, pressure being even and its force on the fluid odd; at one with no slip forces along the wall
/// are odd like the velocity that they change. The ghost then moves with 2 W(v) - v of that node, so that fluid at the
/// wall moves just as the wall says. Across a periodic boundary the same is done with nothing mirrored.
class Mirrors {
 public:
  /// Throws std::invalid_argument for a wall off the grid.
  Mirrors(const std::vector<Wall>& walls, const Grid& grid) {
    if (grid.periodic_x) {
      lines_.push_back({.axis = 0, .ghosts = 0, .inner = grid.columns});
      lines_.push_back({.axis = 0, .ghosts = grid.columns + 1, .inner = 1});
    }
    if (grid.periodic_y) {
      lines_.push_back({.axis = 1, .ghosts = 0, .inner = grid.rows});
      lines_.push_back({.axis = 1, .ghosts = grid.rows + 1, .inner = 1});
    }
    for (const Wall& wall : walls) {
      const int below = grid.line_of(wall), above = below + 1;
      lines_.push_back({.axis = wall.axis,
                        .ghosts = wall.inward > 0 ? below : above,
                        .inner = wall.inward > 0 ? above : below,
                        .wall = wall});
    }
  }

  void list_near(const AffineNodes& nodes) {
    for (Line& line : lines_) line.list_near(nodes);
  }

  /// Takes what the ghosts were given to the nodes in the fluid, as walls answer at `time` [s].
  void fold(AffineNodes& nodes, double time) const {
    for (const Line& line : lines_)
      for (const auto& [ghost, inner] : line.pairs) {
        const double m = nodes.mass[ghost];
        if (!(m > Nodes::least_mass)) continue;
        nodes.mass[inner] += m;
        nodes.momentum.set(inner, nodes.momentum[inner] + m * line.mirrored(nodes.momentum[ghost] / m, time));
      }
  }

  /// Has the ghosts move as the nodes in the fluid have them; in a corner a ghost mirrors a ghost.
  void unfold(AffineNodes& nodes, double time) const {
    for (auto line = lines_.rbegin(); line != lines_.rend(); ++line)
      for (const auto& [ghost, inner] : line->pairs)
        nodes.velocity.set(ghost, line->mirrored(nodes.velocity[inner], time));
  }

 private:
  struct Line {
    int axis, ghosts, inner;  // columns of nodes (axis 0) or rows (1)
    std::optional<Wall> wall{};
    std::vector<std::pair<int, int>> pairs{};  // ghost and node in the fluid, those near particles

    Vec2 mirrored(const Vec2& v, double time) const { return wall ? Vec2(2 * wall->at_wall(v, time) - v) : v; }

    void list_near(const AffineNodes& nodes) {
      const int step = (inner - ghosts) * (axis == 0 ? 1 : nodes.stride);
      pairs.clear();
      for (int first : nodes.near())
        for (int node = first; node < first + lanes; ++node) {
          const int column = node % nodes.stride, row = node / nodes.stride;
          if ((axis == 0 ? column : row) == ghosts && column < nodes.columns) pairs.emplace_back(node, node + step);
        }
    }
  };
  std::vector<Line> lines_;  // in the order in which they are folded
};

}  // namespace touchstone::mpm
