#pragma once
/// Scenes that the tests of all material point methods share, and what all of them must notice.

#include "solvers/fluids/tait.hpp"
#include "solvers/forces/force_field.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/scene.hpp"
#include "solvers/stepping/diverged.hpp"
#include "solvers/walls/free_slip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

namespace touchstone::mpm {

inline constexpr Tait soft_water{.density = 1000, .bulk_modulus = 143};  // sound travels at 1 m/s

// Tests name few kinds of scenes, as each of them takes a second to compile for each method: forces that differ from
// place to place are all `ForceField`s.

/// A force that acts in the first step only [m/s²].
template <class Acceleration>
ForceField blow(const Acceleration& at) {
  return {[=](const Vec2& x, double time) -> Vec2 { return time == 0 ? Vec2(at(x)) : Vec2(0, 0); }};
}

/// Vortices of a size [m] that stir, so that no term of the step is idle, of a strength [m/s²].
inline ForceField stirring(const Vec2& size, double strength) {
  return {[=](const Vec2& x, double) -> Vec2 {
    const Eigen::Array2d angle = 2 * 3.14159 * x.array() / size.array();
    return strength * Vec2(std::sin(angle.x()) * std::cos(angle.y()) + 0.3, -std::cos(angle.x()) * std::sin(angle.y()));
  }};
}

/// A square of fluid in the middle of nowhere.
template <class Force>
Scene<Tait, Force> drop(const Force& force) {
  return {.domain = {.box = {.low = {-1, -1}, .high = {2, 2}}},
          .fluid = soft_water,
          .filled = {.high = {1, 1}},
          .body_force = force};
}

/// A force that is not a number from the eighth step of 10 ms on, near the last of a hundred particles of the drop.
inline ForceField spoilt() {
  return {[](const Vec2& x, double time) -> Vec2 {
    const bool is_there = time > 0.065 && (x - Vec2(0.95, 0.95)).norm() < 0.01;
    return {is_there ? std::numeric_limits<double>::quiet_NaN() : 0.0, 0};
  }};
}

/// Expects a drop of a hundred particles, which falls by 10 m/s², to be stopped as it leaves its domain.
template <class Solver>
void expect_stop_of_a_fall(Solver falling) {
  try {
    for (int k = 0; k < 200; ++k) falling.step();
    FAIL() << "nothing was noticed";
  } catch (const Diverged& diverged) {
    EXPECT_EQ(diverged.fault.quantity, "y [m]");
    EXPECT_LT(diverged.fault.value, -1);
    EXPECT_EQ(diverged.fault.particle, 0);
    EXPECT_EQ(diverged.fault.step, falling.steps());
    EXPECT_NEAR(diverged.fault.time, std::sqrt(2 * 1.05 / 10), 0.02);  // the fall from 0.05 m to -1 m
  }
}

/// Expects a drop under the force `spoilt` to be stopped in the step that spoils it; the particle that is named, if
/// any.
template <class Solver>
void expect_stop_of_spoilt(Solver poisoned, std::optional<long> particle = {}) {
  for (int k = 0; k < 7; ++k) poisoned.step();
  try {
    poisoned.step();
    FAIL() << "nothing was noticed";
  } catch (const Diverged& diverged) {
    EXPECT_EQ(diverged.fault.step, 8);
    EXPECT_TRUE(std::isnan(diverged.fault.value));
    EXPECT_EQ(diverged.fault.particle, particle.value_or(diverged.fault.particle));
  }
}

/// A heap in a corner whose fluid is stirred; cells of 0.1 m become 0.103 m by 0.096 m.
inline Scene<Tait, ForceField> heap() {
  return {.domain = {.box = {.high = {1.24, 0.86}}},
          .fluid = {.density = 1000, .bulk_modulus = 2000},
          .filled = {.high = {0.45, 0.6}},
          .walls = {left_at(0, free_slip()), floor_at(0, free_slip())},
          .body_force = stirring({0.8, 0.7}, 3)};
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
