#pragma once
/// Scenes that the tests of all material point methods share.

#include "solvers/fluids/tait.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/scene.hpp"
#include "solvers/walls/free_slip.hpp"

namespace touchstone::mpm {

inline constexpr Tait soft_water{.density = 1000, .bulk_modulus = 143};  // sound travels at 1 m/s

/// A force that acts in the first step only.
template <class Field>
struct Blow {
  Field acceleration;

  Vec2 operator()(const Vec2& x, double time) const { return time == 0 ? acceleration(x) : Vec2(0, 0); }
};
template <class Field>
Blow(Field) -> Blow<Field>;

/// A square of fluid in the middle of nowhere.
template <class Force>
Scene<Tait, Force> drop(const Force& force) {
  return {.domain = {.box = {.low = {-1, -1}, .high = {2, 2}}},
          .fluid = soft_water,
          .filled = {.high = {1, 1}},
          .body_force = force};
}

/// A column that collapses in a tank of that height [m].
inline Scene<Tait, Uniform> dam(double height = 2) {
  return {.domain = {.box = {.high = {1, height}}},
          .fluid = {.density = 1000, .bulk_modulus = 2000},
          .filled = {.high = {0.4, 0.6}},
          .walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(1, free_slip())},
          .body_force = {{0, -1}}};
}

}  // namespace touchstone::mpm
