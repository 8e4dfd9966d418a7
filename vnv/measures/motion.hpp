#pragma once
/// Whether a fluid moves with its velocity: where it goes over time, by what its velocity says.

#include "vnv/case.hpp"

#include <functional>

namespace touchstone::vnv {

/// A moment of a fluid: the mean, by mass, of a function of the place, and the slope of that function.
struct Moment {
  std::function<double(const Vec2& x)> of;
  std::function<Vec2(const Vec2& x)> slope;
};

inline const Quantity part_of_motion_found{"part of the motion that the velocity makes", ""};

/// How much of the rate at which a moment changes between the samples of a run their velocities make, by least squares
/// over the times: 1 of what moves with its velocity, 0 of a velocity that is zero, -1 of a reversed one. Theirs is the
/// mean of the rates before and after: with a fifth of a period between two times 0.86 of an oscillation. Throws
/// std::invalid_argument where nothing changes.
Measurement part_of_motion(const Moment& moment);

/// Claimed of any method: at least half of it, and at most one and a half.
Claim moves_by_its_velocity();

}  // namespace touchstone::vnv
