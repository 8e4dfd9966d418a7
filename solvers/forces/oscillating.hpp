#pragma once
/// A force that swings, the same on every unit of mass.

#include "solvers/fields.hpp"

#include <cmath>

namespace touchstone {

struct Oscillating {
  Vec2 amplitude;            // m/s²
  double angular_frequency;  // 1/s

  Vec2 operator()(const Vec2& /*x*/, double time) const { return std::cos(angular_frequency * time) * amplitude; }
};

}  // namespace touchstone
