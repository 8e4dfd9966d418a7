#pragma once
#include "solvers/mpm/grid.hpp"
#include "solvers/walls/contacts.hpp"

namespace touchstone::mpm {

/// Contact of particles with walls at the edges of the domain, which lets none through.
///
/// The velocity of the nodes vanishes on a wall. But of a lone particle at X cells from it the node next to the wall
/// has a mass of 2 X and a force that does not get smaller: its velocity, times 2 X, is as large as ever, and where the
/// particle is under tension it is drawn through the wall. It is held there: a contact that is unilateral, inelastic
/// and without friction (Moreau 1988). On the wall it weighs nothing at that node.
class WallContact {
 public:
  WallContact(const std::vector<Wall>& walls, const Grid& grid) : walls_(walls), cell_(grid.cell) {
    std::erase_if(walls_, [](const Wall& wall) { return wall.is_partial(); });
  }

  Contacts sum;

  /// For a particle at x [m] that has passed a wall, by a hundredth of a cell at most, put(wall) puts it on the wall
  /// and returns its velocity along the wall's axis, which loses what goes into the wall. Farther is no contact, but a
  /// run that diverges.
  template <class Put>
  void meet(double mass, const Vec2& x, const Put& put) {
    for (const Wall& wall : walls_) {
      const double behind = -wall.distance(x) / cell_[wall.axis];
      if (!(behind > 0 && behind <= deepest)) continue;
      double& velocity = put(wall);
      const double before = wall.inward * velocity, after = std::max(before, 0.0);
      velocity = wall.inward * after;
      sum.add(mass, wall.normal(), before, after);
    }
  }

 private:
  static constexpr double deepest = 0.01;  // cells

  std::vector<Wall> walls_;
  Vec2 cell_;  // m
};

}  // namespace touchstone::mpm
