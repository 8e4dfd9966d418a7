#pragma once
#include "solvers/fields.hpp"
#include "solvers/forces/none.hpp"
#include "solvers/forces/uniform.hpp"

#include <concepts>

namespace touchstone::mpm {

/// A force that differs from place to place is given to the nodes by the particles; the same force everywhere is added
/// to the nodes' accelerations, which the weights leave as it is.
template <class Force>
concept Local = is_present<Force> && !std::same_as<Force, Uniform>;

/// What the particles give of a force.
template <class Force>
const Force& local(const Force& force) requires Local<Force> {
  return force;
}
template <class Force>
NoForce local(const Force&) {
  return {};
}

/// Per mass [m/s²], at a place [m] and a time [s].
template <class Force>
Vec2 force_on_moving(const Force& force, const Vec2& x, double time, const Vec2& v) {
  if constexpr (requires { force(x, time, v); })
    return force(x, time, v);
  else
    return force(x, time);
}

/// The acceleration that is the same everywhere [m/s²].
inline Vec2 common_acceleration(const Uniform& force) { return force.per_mass; }
template <class Force>
Vec2 common_acceleration(const Force&) {
  return Vec2::Zero();
}

}  // namespace touchstone::mpm
