#pragma once
#include "solvers/walls/wall.hpp"

namespace touchstone {

/// The fluid slides along a wall at rest and does not cross it.
inline WallVelocity free_slip() {
  return [](const NearWall& fluid) -> Vec2 { return fluid.v - fluid.v.dot(fluid.n) * fluid.n; };
}

}  // namespace touchstone
