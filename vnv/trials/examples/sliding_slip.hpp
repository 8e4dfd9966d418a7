#pragma once
#include "solvers/lattice.hpp"

namespace touchstone {

/// A wall that moves along itself with `velocity` [m/s] and over which the fluid slides with a slip length b [m].
inline WallVelocity sliding_slip(const Vec2& velocity, double slip_length) {
  require_positive("sliding_slip", "slip length [m]", slip_length);
  return [=](const NearWall& fluid) -> Vec2 {
    const Vec2 along = fluid.v - fluid.v.dot(fluid.n) * fluid.n;
    return velocity + slip_length / (slip_length + fluid.distance) * (along - velocity);
  };
}

}  // namespace touchstone
