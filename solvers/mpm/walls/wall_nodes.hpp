#pragma once
#include "solvers/mpm/printed/nodes.hpp"
#include "solvers/mpm/walls/held_nodes.hpp"
#include "solvers/mpm/walls/node_at_wall.hpp"
#include "solvers/scene.hpp"

#include <vector>

namespace touchstone::mpm {

/// The nodes on the walls of a scene, and how they are held there.
class WallNodes {
 public:
  /// Throws std::invalid_argument for a wall off the grid.
  WallNodes(const std::vector<Wall>& walls, const Start& start, const Grid& grid, const CornerNodes& nodes,
            WallTreatment treatment)
      : walls_(walls), treat_(treatment) {
    std::vector<HeldNode> all;
    for (std::size_t wall = 0; wall < walls.size(); ++wall)
      for (int node : grid.nodes_on(walls[wall]))
        for (int image : nodes.images(node, grid)) all.push_back({image, wall, start.velocity_at(grid.place_of(node))});
    held_ = HeldNodes(std::move(all));
  }

  void list_near(const CornerNodes& nodes) { held_.list_near(nodes.near()); }

  /// Has the motion of each wall node follow its walls, over the step from `start` [s].
  void hold(CornerNodes& nodes, const Grid& grid, double start, double dt) const {
    const auto motion = [&](const HeldNode& held) -> NodeAtWall {
      const Vec2 v = nodes.velocity[held.node];
      return {v, v + nodes.change[held.node], start, start + dt, start == 0, held.of_scene};
    };
    hold_motion(held_, walls_, treat_, motion, [&](int node, const NodeAtWall& at_wall) {
      if (!nodes.moves(node)) return;
      nodes.change.set(node, at_wall.after - at_wall.before);
      nodes.displacement.set(node, dt * at_wall.after.cwiseQuotient(grid.cell));
    });
  }

  /// Makes the remapped velocities those of the walls, at a time [s].
  void hold_remapped(CornerNodes& nodes, double time) const {
    for (const HeldNode& held : held_)
      if (nodes.moves(held.node))
        nodes.velocity.set(held.node, walls_[held.wall].at_wall(nodes.velocity[held.node], time));
  }

 private:
  std::vector<Wall> walls_;
  WallTreatment treat_;
  HeldNodes held_;
};

}  // namespace touchstone::mpm
