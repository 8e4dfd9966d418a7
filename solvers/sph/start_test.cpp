/// How runs start and how they repeat along both axes, for all methods of this room.

#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/printed.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "solvers/sph/transport_velocity.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace touchstone::sph {
namespace {

constexpr Newtonian oil{{.density = 1000, .bulk_modulus = 14300}, 20};  // sound travels at 10 m/s
constexpr double spacing = 0.05;

/// A box of fluid that repeats along both axes.
Scene<Newtonian> endless(const Start& start) {
  const Vec2 size(1, 1);
  return {.domain = {.box = {.high = size}, .periodic_x = true, .periodic_y = true},
          .fluid = oil,
          .filled = {.high = size},
          .start = start};
}

struct PrintedMethod {
  static auto solver(const Scene<Newtonian>& scene, int threads = 1) {
    const double h = 1.2 * spacing;
    return printed<CubicSpline>(
        scene, {.spacing = spacing, .smoothing_length = h, .time_step = 1e-3, .threads = threads},
        momentum(Pressure{}, LaminarViscosity{.nu = oil.kinematic_viscosity(), .eta = 0.1 * h}));
  }
};
struct TransportMethod {
  static auto solver(const Scene<Newtonian>& scene, int threads = 1) {
    return transport_velocity<QuinticSpline>(
        scene, {.spacing = spacing, .smoothing_length = spacing, .time_step = 1e-3, .threads = threads},
        momentum(PressureDifference{}, MorrisViscosity{.mu = oil.viscosity}));
  }
};

template <class Method>
Samples after(int steps, const Scene<Newtonian>& scene, int threads = 1) {
  auto simulation = Method::solver(scene, threads);
  for (int k = 0; k < steps; ++k) simulation.step();
  return simulation.samples();
}

template <class Method>
class SphStart : public testing::Test {};
using Methods = testing::Types<PrintedMethod, TransportMethod>;
TYPED_TEST_SUITE(SphStart, Methods);

TYPED_TEST(SphStart, ARunHasTheVelocityAndThePressureOfItsScene) {
  const Start start{.velocity = [](const Vec2& x) -> Vec2 {
                      return {2 * x.y(), x.x() - 0.5};
                    },
                    .pressure = [](const Vec2& x) { return 100 * x.x() - 30; }};
  const Samples s = after<TypeParam>(0, endless(start));
  for (Index i = 0; i < s.size(); ++i) {
    const Vec2 x = s.x.col(i);
    EXPECT_LT((s.v.col(i) - start.velocity(x)).norm(), 1e-14);
    EXPECT_NEAR(s.pressure[i], start.pressure(x), 1e-8);
  }
}

TYPED_TEST(SphStart, UniformFlowCrossesBothSeamsUnchanged) {
  const Vec2 v(7, -5);
  const Scene<Newtonian> scene = endless({.velocity = [=](const Vec2&) -> Vec2 { return v; }});
  const Samples start = after<TypeParam>(0, scene), end = after<TypeParam>(400, scene);
  EXPECT_LT((end.v.colwise() - v).norm(), 1e-9);
  EXPECT_LT((end.density - 1000).abs().maxCoeff(), 1e-7);
  for (const int axis : {0, 1}) {
    const Scalars periods = (start.x.row(axis) - end.x.row(axis)).array() + 0.4 * v[axis];
    EXPECT_LT((periods - periods.round()).abs().maxCoeff(), 1e-9) << axis;
  }
}

/// What is left of the amplitude of a wave of shear that varies along an axis.
template <class Method>
double left_of_wave(int axis, int steps) {
  constexpr double k = 2 * std::numbers::pi;
  const Start start{
      .velocity = [=](const Vec2& x) -> Vec2 { return 0.01 * std::sin(k * x[axis]) * Vec2::Unit(1 - axis); }};
  const Samples s = after<Method>(steps, endless(start));
  return 200 * (s.v.row(1 - axis).array() * (k * s.x.row(axis).array()).sin()).mean();
}

TYPED_TEST(SphStart, AShearWaveDecaysAlikeAlongBothAxes) {
  const double along_x = left_of_wave<TypeParam>(0, 1000), along_y = left_of_wave<TypeParam>(1, 1000);
  EXPECT_NEAR(along_x, along_y, 1e-9);
  const double exact = std::exp(-0.02 * 4 * std::numbers::pi * std::numbers::pi);
  EXPECT_NEAR(along_x, exact, 0.05 * exact);
}

TYPED_TEST(SphStart, ThreadsDoNotChangeABitWhereRowsRepeat) {
  const Start start{.velocity = [](const Vec2& x) -> Vec2 { return {std::sin(7 * x.y()), std::cos(5 * x.x())}; }};
  const Samples one = after<TypeParam>(60, endless(start)), three = after<TypeParam>(60, endless(start), 3);
  EXPECT_EQ(one.x, three.x);
  EXPECT_EQ(one.v, three.v);
}

TEST(Images, StandBeyondBothSeamsAndBeyondTheCorner) {
  Particles all;
  all.fluid = 3;
  all.x = Scalars{{0.1, 0.5, 0.9, 0}};
  all.y = Scalars{{0.1, 0.5, 0.5, 0}};
  Images images;
  images.choose(all, {.box = {.high = {1, 1}}, .periodic_x = true, .periodic_y = true}, 0.2);
  ASSERT_EQ(all.images, 4);  // three of the one in the corner, one of that near the right edge
  std::vector<std::pair<double, double>> places;
  for (Index k = 0; k < 4; ++k) places.emplace_back(all.x[3 + k], all.y[3 + k]);
  EXPECT_EQ(places, (std::vector<std::pair<double, double>>{{1.1, 0.1}, {0.1, 1.1}, {1.1, 1.1}, {0.9 - 1, 0.5}}));
}

}  // namespace
}  // namespace touchstone::sph
