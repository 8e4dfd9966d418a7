#pragma once
#include "solvers/fields.hpp"
#include "solvers/mpm/cell_lanes.hpp"
#include "solvers/mpm/walls/node_at_wall.hpp"
#include "solvers/walls/wall.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace touchstone::mpm {

/// The node along an axis that alone carries what is on a line of the grid, where a wall stands. Throws
/// std::invalid_argument if there is none: with wider shapes than hats inside the domain or on a periodic boundary.
template <class Along>
int node_alone_at(int line, const Along& along, const Wall& wall) {
  const auto near = along.near(line);
  const auto alone = std::find(near.weight.begin(), near.weight.end(), 1.0);
  if (alone == near.weight.end())
    throw std::invalid_argument(
        fmt::format("mpm: wall at {} = {:g} m, expected at an edge of the domain that is not periodic: this shape has "
                    "no node of its own elsewhere",
                    wall.axis == 0 ? "x" : "y", wall.position));
  return near.first + static_cast<int>(alone - near.weight.begin());
}

/// A node on a wall.
struct HeldNode {
  int node;
  std::size_t wall;  // of the scene
  Vec2 of_scene;     // m/s  velocity of the fluid there when the run starts
};

/// Has the motion of each node follow its walls: motion(held) is what it would be, set(node, motion) keeps what it is.
/// `held` are HeldNode by node, each with its walls in the order of the scene.
template <class Held, class Motion, class Set>
void hold_motion(const Held& held, const std::vector<Wall>& walls, WallTreatment treat, const Motion& motion,
                 const Set& set) {
  for (auto at = held.begin(); at < held.end();) {
    const int node = at->node;
    NodeAtWall at_wall = motion(*at);
    for (; at < held.end() && at->node == node; ++at) treat(walls[at->wall], at_wall);
    set(node, at_wall);
  }
}

/// The nodes on the walls of a scene, each with its walls in the order of the scene: two in a corner, applied in turn.
/// Only those near particles are held.
class HeldNodes {
 public:
  HeldNodes() = default;
  explicit HeldNodes(std::vector<HeldNode> all) : all_(std::move(all)) {
    std::stable_sort(all_.begin(), all_.end(), [](const HeldNode& a, const HeldNode& b) { return a.node < b.node; });
  }

  /// `near` are the first nodes of registers, ascending.
  void list_near(const std::vector<int>& near) {
    held_.clear();
    for (int first : near) {
      auto held =
          std::lower_bound(all_.begin(), all_.end(), first, [](const HeldNode& h, int node) { return h.node < node; });
      for (; held < all_.end() && held->node < first + lanes; ++held) held_.push_back(*held);
    }
  }
  auto begin() const { return held_.begin(); }
  auto end() const { return held_.end(); }

 private:
  std::vector<HeldNode> all_, held_;
};

}  // namespace touchstone::mpm
