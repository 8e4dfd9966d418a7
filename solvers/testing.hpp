#pragma once
/// What the tests of both methods share: a fluid without bounds, how it starts, and what must come of it.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/samples.hpp"
#include "solvers/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace touchstone {

/// Sound travels at 10 m/s.
inline constexpr Newtonian oil{{.density = 1000, .bulk_modulus = 14300}, 20};

/// A box of fluid that repeats along both axes.
inline Scene<Newtonian> endless(const Start& start, const Vec2& size = {1, 1}) {
  return {.domain = {.box = {.high = size}, .periodic_x = true, .periodic_y = true},
          .fluid = oil,
          .filled = {.high = size},
          .start = start};
}

/// What a method, made by `Method::solver(scene, settings)`, has after some steps.
template <class Method, class SceneOfRun, class... Settings>
Samples after(int steps, const SceneOfRun& scene, const Settings&... settings) {
  auto simulation = Method::solver(scene, settings...);
  for (int k = 0; k < steps; ++k) simulation.step();
  return simulation.samples();
}

/// A start whose velocity and pressure differ from place to place.
inline Start varied_start() {
  return {.velocity = [](const Vec2& x) -> Vec2 {
            return {2 * x.y(), x.x() - 0.5};
          },
          .pressure = [](const Vec2& x) { return 100 * x.x() - 30; }};
}

inline Start uniform_flow(const Vec2& v) {
  return {.velocity = [=](const Vec2&) -> Vec2 { return v; }};
}

/// A wave of shear of one metre that varies along an axis.
inline Start shear_wave(int axis, double amplitude) {
  return {.velocity = [=](const Vec2& x) -> Vec2 {
    return amplitude * std::sin(2 * std::numbers::pi * x[axis]) * Vec2::Unit(1 - axis);
  }};
}

inline double amplitude_of_wave(const Samples& s, int axis) {
  return 2 * (s.v.row(1 - axis).array() * (2 * std::numbers::pi * s.x.row(axis).array()).sin()).mean();
}

inline void expect_as_in(const Start& start, const Samples& s, double velocity_tolerance, double pressure_tolerance) {
  for (Eigen::Index p = 0; p < s.size(); ++p) {
    const Vec2 x = s.x.col(p);
    EXPECT_LT((s.v.col(p) - start.velocity(x)).norm(), velocity_tolerance);
    EXPECT_NEAR(s.pressure[p], start.pressure(x), pressure_tolerance);
  }
}

/// All of `start` is carried along by v for a time, through the seams of a box of that size.
inline void expect_carried(const Samples& start, const Samples& end, const Vec2& v, double time, const Vec2& size) {
  EXPECT_LT((end.v.colwise() - v).norm(), 1e-9);
  EXPECT_LT((end.density - oil.density).abs().maxCoeff(), 1e-7);
  for (const int axis : {0, 1}) {
    const Scalars periods = ((start.x.row(axis) - end.x.row(axis)).array() + time * v[axis]) / size[axis];
    EXPECT_LT((periods - periods.round()).abs().maxCoeff(), 1e-9) << axis;
  }
}

}  // namespace touchstone
