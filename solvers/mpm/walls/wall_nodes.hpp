#pragma once
#include "solvers/mpm/printed/nodes.hpp"
#include "solvers/mpm/walls/node_at_wall.hpp"
#include "solvers/scene.hpp"

#include <algorithm>
#include <vector>

namespace touchstone::mpm {

/// The nodes on the walls of a scene, each with its walls in the order of the scene: two in a corner, applied in turn.
/// Only those near particles are held.
class WallNodes {
 public:
  /// Throws std::invalid_argument for a wall off the grid.
  WallNodes(const std::vector<Wall>& walls, const Start& start, const Grid& grid, const Nodes& nodes,
            WallTreatment treatment)
      : walls_(walls), treat_(treatment) {
    for (std::size_t wall = 0; wall < walls.size(); ++wall)
      for (int node : grid.nodes_on(walls[wall]))
        for (int image : nodes.images(node, grid))
          all_.push_back({image, static_cast<int>(wall), start.velocity_at(grid.place_of(node))});
    std::stable_sort(all_.begin(), all_.end(), [](const Held& a, const Held& b) { return a.node < b.node; });
  }

  void list_near(const Nodes& nodes) {
    held_.clear();
    for (int first : nodes.near()) {
      auto held =
          std::lower_bound(all_.begin(), all_.end(), first, [](const Held& h, int node) { return h.node < node; });
      for (; held < all_.end() && held->node < first + lanes; ++held) held_.push_back(*held);
    }
  }

  /// Has the motion of each wall node follow its walls, over the step from `start` [s].
  void hold(Nodes& nodes, const Grid& grid, double start, double dt) const {
    for (auto held = held_.begin(); held < held_.end();) {
      const int node = held->node;
      const Vec2 v = nodes.velocity[node];
      NodeAtWall at_wall{v, v + nodes.change[node], start, start + dt, start == 0, held->of_scene};
      for (; held < held_.end() && held->node == node; ++held) treat_(walls_[held->wall], at_wall);
      if (!nodes.moves(node)) continue;
      nodes.change.set(node, at_wall.after - at_wall.before);
      nodes.displacement.set(node, dt * at_wall.after.cwiseQuotient(grid.cell));
    }
  }

  /// Makes the remapped velocities those of the walls, at a time [s].
  void hold_remapped(Nodes& nodes, double time) const {
    for (const Held& held : held_)
      if (nodes.moves(held.node))
        nodes.velocity.set(held.node, walls_[held.wall].at_wall(nodes.velocity[held.node], time));
  }

 private:
  struct Held {
    int node, wall;
    Vec2 of_scene;  // m/s  velocity of the fluid there when the run starts
  };
  std::vector<Wall> walls_;
  WallTreatment treat_;
  std::vector<Held> all_, held_;
};

}  // namespace touchstone::mpm
