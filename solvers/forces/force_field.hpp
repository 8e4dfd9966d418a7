#pragma once
/// A body force of any kind, its type forgotten: one call through a pointer for each particle and step. A force that is
/// the same everywhere is `Uniform`, which costs nothing of that.

#include "solvers/fields.hpp"

#include <functional>

namespace touchstone {

struct ForceField {
  std::function<Vec2(const Vec2& x, double time)> at;  // m/s²  at a place [m] and a time [s]

  Vec2 operator()(const Vec2& x, double time) const { return at(x, time); }
};

}  // namespace touchstone
