#pragma once
/// A body force on fluid that moves: most forces do not ask how.

#include "solvers/fields.hpp"

namespace touchstone {

/// Per mass [m/s²], at a place [m] and a time [s].
template <class Force>
Vec2 force_on_moving(const Force& force, const Vec2& x, double time, const Vec2& v) {
  if constexpr (requires { force(x, time, v); })
    return force(x, time, v);
  else
    return force(x, time);
}

}  // namespace touchstone
