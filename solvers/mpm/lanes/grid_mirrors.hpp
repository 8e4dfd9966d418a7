#pragma once
/// Walls where quadratic B-splines are whole: they mirror.

#include "solvers/mpm/lanes/grid_walls.hpp"

namespace touchstone::mpm {

/// With nodes at cell centres a wall lies midway between a line of nodes in the fluid and a line of ghosts behind it,
/// and every particle beside it has an image behind it.
///
/// What a particle gives to a ghost, its image gives to the node in the fluid: the same mass, and the momentum m v
/// mirrored by the wall's answer, m (2 W(v) - v). Body force and stress are parts of that momentum: at a wall with free
/// slip this is exact, pressure being even and its force on the fluid odd; at one with no slip forces along the wall
/// are odd like the velocity that they change. The ghost then moves with 2 W(v) - v of that node, so that fluid at the
/// wall moves just as the wall says.
template <>
class LaneWalls<QuadraticBSpline> {
  using Shape = ShapeInLanes<QuadraticBSpline>;
  using Nodes = LaneNodes<Shape>;

 public:
  /// Throws std::invalid_argument for a wall off the grid.
  LaneWalls(const std::vector<Wall>& walls, const Start&, const Grid& grid, const Shape&, const Nodes&) {
    for (const Wall& wall : walls) {
      const int below = grid.line_of(wall), above = below + 1;
      lines_.push_back({{wall.axis, wall.inward > 0 ? below : above, wall.inward > 0 ? above : below}, wall});
    }
  }

  void list_near(const Nodes& nodes) {
    for (MirrorLine& line : lines_) line.list_near(nodes);
  }

  /// Takes what the ghosts were given to the nodes in the fluid and has the ghosts move as these have them, as walls
  /// answer at a time [s]; in a corner a ghost mirrors a ghost. Once for what the nodes were given.
  void hold(Nodes& nodes, double time, NodeVectors& velocity) const {
    for (const MirrorLine& line : lines_)
      for (const int ghost : line.ghosts)
        if (nodes.moves(ghost))
          nodes.join(ghost + line.step, 1 / nodes.per_mass[ghost], line.mirrored(velocity[ghost], time), velocity);
    for (auto line = lines_.rbegin(); line != lines_.rend(); ++line)
      for (const int ghost : line->ghosts) velocity.set(ghost, line->mirrored(velocity[ghost + line->step], time));
  }

 private:
  struct MirrorLine : GhostLine {
    Wall wall;

    Vec2 mirrored(const Vec2& v, double time) const { return 2 * wall.at_wall(v, time) - v; }
  };
  std::vector<MirrorLine> lines_;  // in the order in which they are folded
};

}  // namespace touchstone::mpm
