#pragma once
#include "solvers/walls/wall.hpp"

#include <cmath>

namespace touchstone {

/// The fluid moves with a wall that swings along itself, with `amplitude` [m/s] cos(angular frequency [1/s] t).
inline WallVelocity oscillating(const Vec2& amplitude, double angular_frequency) {
  return [=](const NearWall& fluid) -> Vec2 { return std::cos(angular_frequency * fluid.time) * amplitude; };
}

}  // namespace touchstone
