#pragma once
/// What the tests of both methods share: a fluid without bounds, how it starts, and what must come of it.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/forces/force_field.hpp"
#include "solvers/samples.hpp"
#include "solvers/scene.hpp"
#include "solvers/walls/no_slip.hpp"

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

/// Any scene as one of a viscous fluid in a field of forces, if only of 0: each kind of scene takes seconds to compile
/// for each method.
template <class FluidLaw, class Force>
Scene<Newtonian, ForceField> as_one_kind(const Scene<FluidLaw, Force>& scene) {
  Newtonian fluid{scene.fluid, 0};
  if constexpr (Viscous<FluidLaw>) fluid.viscosity = scene.fluid.viscosity;
  ForceField force{[](const Vec2&, double) -> Vec2 { return {0, 0}; }};
  if constexpr (is_present<Force>) force.at = scene.body_force;
  return {scene.domain, fluid, scene.filled, scene.walls, force, scene.start};
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

/// A standing wave of sound of one metre along an axis.
inline Start sound_wave(int axis, double amplitude) {
  return {.velocity = [=](const Vec2& x) -> Vec2 {
    return amplitude * std::sin(2 * std::numbers::pi * x[axis]) * Vec2::Unit(axis);
  }};
}

/// By the energy of its motion and of its compression [m/s].
inline double amplitude_of_sound(const Samples& s) {
  const Scalars compression = oil.sound_speed() * (s.density / oil.density - 1);
  return std::sqrt(2 * (s.v.colwise().squaredNorm().mean() + compression.square().mean()));
}

/// Its decay by viscosity, of which there is 4/3 where fluid is compressed (Landau & Lifshitz, Fluid Mechanics, 79).
inline double sound_left_after(double time) {
  const double k = 2 * std::numbers::pi;
  return std::exp(-oil.kinematic_viscosity() * 2 / 3 * k * k * time);
}

/// The particles of a lattice in reverse, each a little to the right and some of them left out.
inline Vectors rearranged(const Vectors& lattice) {
  Vectors all = lattice.rowwise().reverse().rightCols(lattice.cols() / 2);
  all.row(0).array() += 0.01;
  return all;
}
inline void expect_rearranged(const Samples& started, const Samples& rearranged_start) {
  const Vectors expected = rearranged(started.x);
  ASSERT_EQ(rearranged_start.x.cols(), expected.cols());
  EXPECT_LT((rearranged_start.x - expected).norm(), 1e-12);
}

inline void expect_as_in(const Start& start, const Samples& s, double velocity_tolerance, double pressure_tolerance) {
  for (Eigen::Index p = 0; p < s.size(); ++p) {
    const Vec2 x = s.x.col(p);
    EXPECT_LT((s.v.col(p) - start.velocity(x)).norm(), velocity_tolerance);
    EXPECT_NEAR(s.pressure[p], start.pressure(x), pressure_tolerance);
  }
}

/// A closed box of fluid whose last wall is a lid: the ceiling slides to the right or, what is the same a quarter turn
/// on, the right wall slides down.
inline Scene<Newtonian> closed_box(std::vector<Wall> walls) {
  return {.domain = {.box = {.high = {1, 1}}}, .fluid = oil, .filled = {.high = {1, 1}}, .walls = std::move(walls)};
}
inline Scene<Newtonian> under_a_lid() {
  return closed_box(
      {floor_at(0, no_slip()), left_at(0, no_slip()), right_at(1, no_slip()), ceiling_at(1, no_slip({1, 0}))});
}
inline Scene<Newtonian> beside_a_lid() {
  return closed_box(
      {left_at(0, no_slip()), ceiling_at(1, no_slip()), floor_at(0, no_slip()), right_at(1, no_slip({0, -1}))});
}

/// Places, velocities and pressures of particles that started on a square lattice, `across` of them along a side.
inline void expect_a_quarter_turn_on(const Samples& s, const Samples& turned, Eigen::Index across, double tolerance) {
  for (Eigen::Index row = 0; row < across; ++row)
    for (Eigen::Index column = 0; column < across; ++column) {
      const Eigen::Index p = row * across + column, q = (across - 1 - column) * across + row;
      EXPECT_LT((turned.x.col(q) - Vec2(s.x(1, p), 1 - s.x(0, p))).norm(), tolerance) << p;
      EXPECT_LT((turned.v.col(q) - Vec2(s.v(1, p), -s.v(0, p))).norm(), tolerance) << p;
      EXPECT_NEAR(turned.pressure[q], s.pressure[p], oil.density * tolerance) << p;
    }
}

/// Fluid under a lid turns with it, below it comes back, and what is in the box stays in it.
inline void expect_driven_by_the_lid(const Samples& s) {
  EXPECT_TRUE((s.x.array() >= 0).all() && (s.x.array() <= 1).all());
  const auto mean_along = [&](double low, double high) {
    const Scalars is_between = (s.x.row(1).array() > low && s.x.row(1).array() < high).cast<double>().transpose();
    return (s.v.row(0).transpose().array() * is_between).sum() / is_between.sum();
  };
  EXPECT_GT(mean_along(0.9, 1), 0.3);
  EXPECT_LT(mean_along(0.3, 0.6), -0.02);
  EXPECT_LT(s.v.colwise().norm().maxCoeff(), 1.1);
}

/// All of `start` is carried along by v for a time, across the periodic boundaries of a box of that size.
inline void expect_carried(const Samples& start, const Samples& end, const Vec2& v, double time, const Vec2& size) {
  EXPECT_LT((end.v.colwise() - v).norm(), 1e-9);
  EXPECT_LT((end.density - oil.density).abs().maxCoeff(), 1e-7);
  for (const int axis : {0, 1}) {
    const Scalars periods = ((start.x.row(axis) - end.x.row(axis)).array() + time * v[axis]) / size[axis];
    EXPECT_LT((periods - periods.round()).abs().maxCoeff(), 1e-9) << axis;
  }
}

}  // namespace touchstone
