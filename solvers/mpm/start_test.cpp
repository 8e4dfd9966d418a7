/// How runs start and how they repeat along both axes, for all methods of this room.

#include "solvers/mpm/affine.hpp"
#include "solvers/mpm/mpm.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace touchstone::mpm {
namespace {

constexpr Newtonian oil{{.density = 1000, .bulk_modulus = 14300}, 20};  // sound travels at 10 m/s

/// A box of fluid that repeats along both axes.
Scene<Newtonian> endless(const Start& start, const Vec2& size = {1, 1}) {
  return {.domain = {.box = {.high = size}, .periodic_x = true, .periodic_y = true},
          .fluid = oil,
          .filled = {.high = size},
          .start = start};
}

/// `left_by_damping` is what a method's own damping leaves in so many steps of a wave whose number is `k_cell` per
/// cell.
struct Printed {
  static double left_by_damping(double /*k_cell*/, int /*steps*/) { return 1; }
  static auto solver(const Scene<Newtonian>& scene, const Settings& settings) {
    return mpm::solver<LinearHat, PrescribedMotion>(scene, settings);
  }
};
struct SinglePrinted {
  static auto solver(const Scene<Newtonian>& scene, const Settings& settings) {
    return mpm::solver<LinearHat, PrescribedMotion, float>(scene, settings);
  }
};
struct AffineMethod {
  static double left_by_damping(double k_cell, int steps) { return std::exp(-std::pow(k_cell, 4) / 40 * steps); }
  static auto solver(const Scene<Newtonian>& scene, const Settings& settings) { return affine(scene, settings); }
};

template <class Method>
Samples after(int steps, const Scene<Newtonian>& scene, const Settings& settings) {
  auto simulation = Method::solver(scene, settings);
  for (int k = 0; k < steps; ++k) simulation.step();
  return simulation.samples();
}

template <class Method>
class MpmStart : public testing::Test {};
using Methods = testing::Types<Printed, AffineMethod>;
TYPED_TEST_SUITE(MpmStart, Methods);

TYPED_TEST(MpmStart, ARunHasTheVelocityAndThePressureOfItsScene) {
  const Start start{.velocity = [](const Vec2& x) -> Vec2 {
                      return {2 * x.y(), x.x() - 0.5};
                    },
                    .pressure = [](const Vec2& x) { return 100 * x.x() - 30; }};
  const Samples s = after<TypeParam>(0, endless(start), {.cell = 0.1, .spacing = 0.05, .time_step = 1e-3});
  for (Eigen::Index p = 0; p < s.size(); ++p) {
    const Vec2 x = s.x.col(p);
    EXPECT_LT((s.v.col(p) - start.velocity(x)).norm(), 1e-14);
    EXPECT_NEAR(s.pressure[p], start.pressure(x), 1e-8);
  }
}

TYPED_TEST(MpmStart, ARunWithoutAWordIsAtRest) {
  const Samples s = after<TypeParam>(0, endless({}), {.cell = 0.1, .spacing = 0.05, .time_step = 1e-3});
  EXPECT_EQ(s.v.norm(), 0);
  EXPECT_EQ(s.pressure.abs().maxCoeff(), 0);
}

TYPED_TEST(MpmStart, UniformFlowCrossesBothSeamsUnchanged) {
  const Vec2 v(7, -5), size(0.7, 0.9);
  const Settings settings{.cell = 0.1, .spacing = 0.05, .time_step = 1e-3};
  const Scene<Newtonian> scene = endless({.velocity = [=](const Vec2&) -> Vec2 { return v; }}, size);
  const Samples start = after<TypeParam>(0, scene, settings), end = after<TypeParam>(1000, scene, settings);
  EXPECT_LT((end.v.colwise() - v).norm(), 1e-9);
  EXPECT_LT((end.density - 1000).abs().maxCoeff(), 1e-7);
  for (const int axis : {0, 1}) {
    const Scalars periods = (start.x.row(axis) - end.x.row(axis)).array() / size[axis] + v[axis] / size[axis];
    EXPECT_LT((periods - periods.round()).abs().maxCoeff(), 1e-10) << axis;
  }
}

/// What is left of the amplitude of a wave of shear that varies along an axis.
template <class Method>
double left_of_wave(int axis, int steps, const Settings& settings) {
  constexpr double k = 2 * std::numbers::pi;
  const Start start{
      .velocity = [=](const Vec2& x) -> Vec2 { return 0.1 * std::sin(k * x[axis]) * Vec2::Unit(1 - axis); }};
  const Samples s = after<Method>(steps, endless(start), settings);
  return 20 * (s.v.row(1 - axis).array() * (k * s.x.row(axis).array()).sin()).mean();
}

TYPED_TEST(MpmStart, AShearWaveDecaysAlikeAlongBothAxes) {
  const Settings settings{.cell = 0.05, .spacing = 0.025, .time_step = 2e-3};
  const double along_x = left_of_wave<TypeParam>(0, 500, settings), along_y = left_of_wave<TypeParam>(1, 500, settings);
  EXPECT_NEAR(along_x, along_y, 1e-9);
  constexpr double k = 2 * std::numbers::pi;
  const double expected =
      std::exp(-oil.kinematic_viscosity() * k * k) * TypeParam::left_by_damping(k * settings.cell, 500);
  EXPECT_NEAR(along_x, expected, 0.03 * expected);
}

TYPED_TEST(MpmStart, ThreadsDoNotChangeABitWhereRowsRepeat) {
  const Start start{.velocity = [](const Vec2& x) -> Vec2 { return {std::sin(7 * x.y()), std::cos(5 * x.x())}; }};
  Settings settings{.cell = 0.05, .spacing = 0.02, .time_step = 1e-3};
  const Samples one = after<TypeParam>(100, endless(start), settings);
  settings.threads = 3;
  const Samples three = after<TypeParam>(100, endless(start), settings);
  EXPECT_EQ(one.x, three.x);
  EXPECT_EQ(one.v, three.v);
}

TEST(MpmStartInSinglePrecision, HasTheVelocityAndThePressureOfItsScene) {
  const Start start{.velocity = [](const Vec2& x) -> Vec2 {
                      return {x.y(), 0};
                    },
                    .pressure = [](const Vec2& x) { return 100 * x.x(); }};
  const Samples s = after<SinglePrinted>(0, endless(start), {.cell = 0.1, .spacing = 0.05, .time_step = 1e-3});
  EXPECT_LT((s.v.row(0) - s.x.row(1)).norm(), 1e-5);
  EXPECT_LT((s.pressure - 100 * s.x.row(0).transpose().array()).abs().maxCoeff(), 0.02);
}

}  // namespace
}  // namespace touchstone::mpm
