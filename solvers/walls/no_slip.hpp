#pragma once
#include "solvers/walls/wall.hpp"

namespace touchstone {

/// The fluid moves with the wall, which is still or slides at a constant velocity from t = 0 on.
inline WallVelocity no_slip(const Vec2& wall_velocity = Vec2::Zero()) {
  return [wall_velocity](const NearWall&) -> Vec2 { return wall_velocity; };
}

}  // namespace touchstone
