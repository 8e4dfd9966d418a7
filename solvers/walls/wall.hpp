#pragma once
/// A wall answers one question: fluid near you moves like this; how does it move *at* you?
/// The grid method assigns the answer to its wall nodes; the particle method mirrors it,
/// ghost velocity = 2 (at wall) - v. How a method builds its wall lives with the method; a new wall is one file here.

#include "solvers/fields.hpp"

#include <algorithm>
#include <functional>

namespace touchstone {

/// Fluid near a wall.
struct NearWall {
  Vec2 v;       // m/s  velocity of the fluid
  Vec2 n;       // -    unit normal, into the fluid
  double time;  // s
  /// From the wall to where v is [m]. SPH: where the mean of the fluid is for ghosts that extrapolate; for those that
  /// mirror, where the ghost's mirror image is, at which they take that mean to be. MPM: 0, v is that of a node on the
  /// wall, so that it refuses walls that need a distance.
  double distance;
};

/// A stretch of a line [m].
struct Range {
  double low, high;

  double length() const { return std::max(0.0, high - low); }
};

/// Velocity of the fluid at the wall [m/s].
using WallVelocity = std::function<Vec2(const NearWall&)>;

/// The part of a wall's line where the wall is [m along it], at a time [s].
using WallExtent = std::function<Range(double time)>;

/// A straight wall along x or along y: across the whole domain, or where its extent says, as a gate that is drawn up.
struct Wall {
  int axis;         // 0: the wall is a line of constant x; 1: of constant y
  double position;  // m  on that axis
  double inward;    // +1 or -1: the side on that axis where the fluid is
  WallVelocity velocity;
  WallExtent extent{};  // nothing: all of the line

  bool is_partial() const { return static_cast<bool>(extent); }
  /// Whether the wall is beside a place, at a time [s].
  bool is_beside(const Vec2& x, double time) const {
    if (!extent) return true;
    const Range part = extent(time);
    return x[1 - axis] >= part.low && x[1 - axis] <= part.high;
  }
  Vec2 normal() const { return inward * Vec2::Unit(axis); }
  /// Distance into the fluid [m]; negative behind the wall.
  double distance(const Vec2& x) const { return inward * (x[axis] - position); }
  Vec2 at_wall(const Vec2& v, double time, double distance_of_v = 0) const {
    return velocity({.v = v, .n = normal(), .time = time, .distance = distance_of_v});
  }
  /// Whether fluid that moves alike at two distances moves differently at the wall.
  bool depends_on_distance() const {
    const Vec2 v(1, 2);  // m/s  any that is neither along nor across
    return !(at_wall(v, 0, 0) == at_wall(v, 0, 1));
  }
};

inline Wall floor_at(double y, WallVelocity velocity) { return {1, y, +1, std::move(velocity), {}}; }
inline Wall ceiling_at(double y, WallVelocity velocity) { return {1, y, -1, std::move(velocity), {}}; }
inline Wall left_at(double x, WallVelocity velocity) { return {0, x, +1, std::move(velocity), {}}; }
inline Wall right_at(double x, WallVelocity velocity) { return {0, x, -1, std::move(velocity), {}}; }

}  // namespace touchstone
