#pragma once
/// Gravity in a tank that rolls, seen from within: the tank rests, and what turns with it bears the forces of its frame.

#include "solvers/fields.hpp"

#include <cmath>

namespace touchstone {

/// A roll by `amplitude` sin(angular_frequency t) about a pivot, anticlockwise positive, from the upright at t = 0 on.
/// Besides gravity, in the axes of the tank: Euler's force, Coriolis' and the centrifugal one.
struct Rolling {
  double gravity;            // m/s²
  double amplitude;          // rad
  double angular_frequency;  // 1/s
  Vec2 pivot;                // m

  double angle(double time) const { return amplitude * std::sin(angular_frequency * time); }

  Vec2 operator()(const Vec2& x, double time, const Vec2& v) const {
    const double phi = angle(time), rate = amplitude * angular_frequency * std::cos(angular_frequency * time),
                 acceleration = -angular_frequency * angular_frequency * phi;
    const Vec2 r = x - pivot;
    return -gravity * Vec2(std::sin(phi), std::cos(phi)) + acceleration * Vec2(r.y(), -r.x()) +
           2 * rate * Vec2(v.y(), -v.x()) + rate * rate * r;
  }
};

}  // namespace touchstone
