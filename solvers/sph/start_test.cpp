/// How runs start and how they repeat along both axes, for all methods of this room.

#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "solvers/sph/transport_velocity/transport_velocity.hpp"
#include "solvers/testing.hpp"

#include <cmath>
#include <numbers>

namespace touchstone::sph {
namespace {

constexpr double spacing = 0.05;

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
class SphStart : public testing::Test {};
using Methods = testing::Types<PrintedMethod, TransportMethod>;
TYPED_TEST_SUITE(SphStart, Methods);

TYPED_TEST(SphStart, ARunHasTheVelocityAndThePressureOfItsScene) {
  expect_as_in(varied_start(), after<TypeParam>(0, endless(varied_start())), 1e-14, 1e-8);
}

TYPED_TEST(SphStart, ASceneMayPutItsParticlesElsewhere) {
  expect_rearranged(after<TypeParam>(0, endless({})), after<TypeParam>(0, endless({.places = rearranged})));
}

TYPED_TEST(SphStart, UniformFlowCrossesBothPeriodicBoundariesUnchanged) {
  const Vec2 v(7, -5);
  const Scene<Newtonian> scene = endless(uniform_flow(v));
  expect_carried(after<TypeParam>(0, scene), after<TypeParam>(400, scene), v, 0.4, {1, 1});
}

TYPED_TEST(SphStart, AShearWaveDecaysAlikeAlongBothAxes) {
  const auto left_of_wave = [](int axis) {
    return amplitude_of_wave(after<TypeParam>(1000, endless(shear_wave(axis, 0.01))), axis) / 0.01;
  };
  EXPECT_NEAR(left_of_wave(0), left_of_wave(1), 1e-9);
  const double exact = std::exp(-0.02 * 4 * std::numbers::pi * std::numbers::pi);
  EXPECT_NEAR(left_of_wave(0), exact, 0.05 * exact);
}

TYPED_TEST(SphStart, ThreadsDoNotChangeABitWhereRowsRepeat) {
  const Start start{.velocity = [](const Vec2& x) -> Vec2 { return {std::sin(7 * x.y()), std::cos(5 * x.x())}; }};
  const Samples one = after<TypeParam>(60, endless(start)), three = after<TypeParam>(60, endless(start), 3);
  EXPECT_EQ(one.x, three.x);
  EXPECT_EQ(one.v, three.v);
}

TEST(Walls, RefuseFluidThatStartsOnThem) {
  const Vectors places{{0.5, 0.3}, {0.2, 0.004}};
  const std::vector<Wall> walls = {floor_at(0, [](const NearWall& near) { return near.v; })};
  EXPECT_NO_THROW(require_off_walls(places, walls, 0.04));
  try {
    require_off_walls(places, walls, 0.05);
    FAIL();
  } catch (const std::invalid_argument& refusal) {
    EXPECT_STREQ(refusal.what(),
                 "sph: particle 1 starts at (0.3, 0.004) m, 0.004 m from a wall, expected at least 0.005 m");
  }
}

TEST(Images, StandBeyondBothPeriodicBoundariesAndBeyondTheCorner) {
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
