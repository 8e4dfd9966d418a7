#pragma once
/// The same force on every unit of mass, at all times: gravity, or the drive of a channel.

#include "solvers/fields.hpp"

namespace touchstone {

struct Uniform {
  Vec2 per_mass;  // m/s²

  Vec2 operator()(const Vec2& /*x*/, double /*time*/) const { return per_mass; }
};

}  // namespace touchstone
