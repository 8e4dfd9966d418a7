#pragma once
#include "solvers/mpm/nodes.hpp"
#include "solvers/mpm/walls/node_at_wall.hpp"

#include <map>

namespace touchstone::mpm {

/// The nodes on the walls of a scene, each with its walls in the order of the scene: two in a corner, applied in turn.
class WallNodes {
 public:
  /// Throws std::invalid_argument for a wall off the grid.
  WallNodes(const std::vector<Wall>& walls, const Grid& grid) : walls_(walls) {
    std::map<int, std::vector<std::size_t>> walls_of;
    for (std::size_t wall = 0; wall < walls.size(); ++wall)
      for (int node : grid.nodes_on(walls[wall])) walls_of[node].push_back(wall);
    held_.assign(walls_of.begin(), walls_of.end());
  }

  /// Has the motion of each wall node follow its walls, over the step from `start` [s].
  template <class Treatment>
  void hold(Nodes& nodes, const Grid& grid, double start, double dt) const {
    for (const auto& [node, its_walls] : held_) {
      if (!nodes.moves(node)) continue;
      NodeMotion& motion = nodes.motion[node];
      const Vec2 v = nodes.sums[node].velocity();
      NodeAtWall at_wall{v, v + motion.change, start, start + dt, start == 0};
      for (std::size_t wall : its_walls) Treatment::hold(walls_[wall], at_wall);
      motion.change = at_wall.after - at_wall.before;
      motion.displacement = dt * at_wall.after.cwiseQuotient(grid.cell);
    }
  }

  /// Makes the remapped velocities those of the walls, at a time [s].
  void hold_remapped(Nodes& nodes, double time) const {
    for (const auto& [node, its_walls] : held_) {
      if (!nodes.moves(node)) continue;
      Vec2& v = nodes.motion[node].remapped;
      for (std::size_t wall : its_walls) v = walls_[wall].at_wall(v, time);
    }
  }

 private:
  std::vector<Wall> walls_;
  std::vector<std::pair<int, std::vector<std::size_t>>> held_;
};

}  // namespace touchstone::mpm
