#include "solvers/sph/second_order/second_order.hpp"

#include "solvers/forces/uniform.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/testing.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

namespace touchstone::sph {
namespace {

constexpr double spacing = 0.05;

struct SecondOrderMethod {
  static auto solver(const auto& scene, int threads = 1) {
    return second_order<WendlandC2>(
        as_one_kind(scene),
        {.spacing = spacing, .smoothing_length = 1.3 * spacing, .time_step = 1e-3, .threads = threads});
  }
};

Scene<Newtonian> between_plates(const WallVelocity& low, const WallVelocity& high, const Start& start) {
  return {.domain = {.box = {.high = {1, 1}}, .periodic_x = true},
          .fluid = oil,
          .filled = {.high = {1, 1}},
          .walls = {floor_at(0, low), ceiling_at(1, high)},
          .start = start};
}

TEST(SecondOrderSph, ARunHasTheVelocityAndThePressureOfItsScene) {
  expect_as_in(varied_start(), after<SecondOrderMethod>(0, endless(varied_start())), 1e-14, 1e-8);
}

TEST(SecondOrderSph, UniformFlowCrossesBothPeriodicBoundariesUnchanged) {
  const Vec2 v(7, -5);
  const Scene<Newtonian> scene = endless(uniform_flow(v));
  expect_carried(after<SecondOrderMethod>(0, scene), after<SecondOrderMethod>(400, scene), v, 0.4, {1, 1});
}

TEST(SecondOrderSph, AShearWaveDecaysAsItShouldAlongBothAxes) {
  const double exact = std::exp(-oil.kinematic_viscosity() * 4 * std::numbers::pi * std::numbers::pi);
  for (const int axis : {0, 1}) {
    const double left = amplitude_of_wave(after<SecondOrderMethod>(1000, endless(shear_wave(axis, 0.1))), axis) / 0.1;
    EXPECT_NEAR(left, exact, 0.03 * exact) << axis;
  }
}

TEST(SecondOrderSph, VorticesDecayAsTheyShould) {
  constexpr double k = 2 * std::numbers::pi, U = 0.01;  // m/s  so slow that viscosity alone matters
  const auto vortices = [](const Vec2& x) -> Vec2 {
    return {std::sin(k * x.x()) * std::cos(k * x.y()), -std::cos(k * x.x()) * std::sin(k * x.y())};
  };
  const Start start{.velocity = [=](const Vec2& x) -> Vec2 { return U * vortices(x); }};
  const Samples s = after<SecondOrderMethod>(500, endless(start));
  double left = 0;
  for (Eigen::Index p = 0; p < s.size(); ++p)
    left += 2 / U * s.v.col(p).dot(vortices(s.x.col(p))) / static_cast<double>(s.size());
  const double exact = std::exp(-oil.kinematic_viscosity() * 2 * k * k * 0.5);
  EXPECT_NEAR(left, exact, 0.03 * exact);
}

TEST(SecondOrderSph, AWaveOfSoundDecaysByFourThirdsOfTheViscosityAlongBothAxes) {
  for (const int axis : {0, 1}) {
    const double left = amplitude_of_sound(after<SecondOrderMethod>(1000, endless(sound_wave(axis, 0.01)))) / 0.01;
    EXPECT_NEAR(left, sound_left_after(1), 0.02 * sound_left_after(1)) << axis;
  }
}

TEST(SecondOrderSph, ALinearProfileBetweenSlidingPlatesStaysToTheLastDigits) {
  const Start linear{.velocity = [](const Vec2& x) -> Vec2 { return {2 * x.y() - 1, 0}; }};
  const Samples s = after<SecondOrderMethod>(500, between_plates(no_slip({-1, 0}), no_slip({1, 0}), linear));
  EXPECT_LT((s.v.row(0).array() - (2 * s.x.row(1).array() - 1)).abs().maxCoeff(), 1e-9);
  EXPECT_LT(s.v.row(1).array().abs().maxCoeff(), 1e-9);
}

TEST(SecondOrderSph, FluidSlidesFreelyAlongASlipperyWall) {
  const Samples s = after<SecondOrderMethod>(500, between_plates(free_slip(), free_slip(), uniform_flow({3, 0})));
  EXPECT_LT((s.v.row(0).array() - 3).abs().maxCoeff(), 1e-9);
}

TEST(SecondOrderSph, AForceMovesAllAlike) {
  const Scene<Newtonian, Uniform> scene{.domain = {.box = {.high = {1, 1}}, .periodic_x = true, .periodic_y = true},
                                        .fluid = oil,
                                        .filled = {.high = {1, 1}},
                                        .body_force = {{2, -3}}};
  const Samples s = after<SecondOrderMethod>(100, scene);
  EXPECT_LT((s.v.colwise() - Vec2(0.2, -0.3)).norm(), 1e-9);
}

TEST(SecondOrderSph, ALidDrivesTheFluidInAClosedBoxAndNoneLeaves) {
  expect_driven_by_the_lid(after<SecondOrderMethod>(2000, under_a_lid()));
}

TEST(SecondOrderSph, ALidDrivesAlikeWhicheverWallItIs) {
  expect_a_quarter_turn_on(after<SecondOrderMethod>(100, under_a_lid()), after<SecondOrderMethod>(100, beside_a_lid()),
                           20, 1e-9);
}

TEST(SecondOrderSph, TheMeanDensityOfAClosedBoxStaysWhatItWas) {
  const Samples s = after<SecondOrderMethod>(500, under_a_lid());
  EXPECT_NEAR(s.density.mean(), oil.density, 1e-12 * oil.density);
  EXPECT_GT((s.density - oil.density).abs().maxCoeff(), 1e-4 * oil.density);  // though it changes from place to place
}

TEST(SecondOrderSph, WaterBetweenPlatesRestsUnderItsWeight) {
  constexpr double g = 2;  // m/s²
  const Start at_rest{.pressure = [](const Vec2& x) { return oil.density * g * (1 - x.y()); }};
  const Scene<Newtonian> scene = between_plates(no_slip({0, 0}), free_slip(), at_rest);
  const Scene<Newtonian, Uniform> heavy{scene.domain, scene.fluid, scene.filled, scene.walls, {{0, -g}}, scene.start};
  const Samples s = after<SecondOrderMethod>(100, heavy);  // sound has crossed it once
  EXPECT_LT(s.v.colwise().norm().maxCoeff(), 0.005 * g * s.time);
}

/// Opened, for what happens to few particles and seldom.
struct PutBack : SecondOrder<WendlandC2, AdamsBashforth, double, Newtonian, ForceField> {
  using SecondOrder::SecondOrder, SecondOrder::keep_off, SecondOrder::near_;
};

TEST(SecondOrderSph, AParticlePutBackFromAWallHasTheFieldsOfWhereItIsThen) {
  const std::array<double, 8> carried{0, 0, 1, 2, 3, 4, 5, 6};  // slopes of vx, vy and rho along x and y
  for (const Wall& wall : {right_at(1, no_slip({0, 0})), ceiling_at(1, no_slip({0, 0}))}) {
    PutBack solver(as_one_kind(between_plates(no_slip({0, 0}), no_slip({0, 0}), {})),
                   {.spacing = spacing, .smoothing_length = 1.3 * spacing, .time_step = 1e-3});
    Particles& all = solver.near_.all;
    const double back = -0.2 * spacing;
    all.x[0] = all.y[0] = 0.5;
    (wall.axis == 0 ? all.x : all.y)[0] = 1 - 0.05 * spacing;  // a fourth of the spacing is the least
    all.vx[0] = all.vy[0] = all.rho[0] = 0;
    for (std::size_t k = 0; k < carried.size(); ++k) all.carried[k][0] = carried[k];
    solver.keep_off(wall, 0, all.fluid);
    EXPECT_DOUBLE_EQ((wall.axis == 0 ? all.x : all.y)[0], 1 - 0.25 * spacing);
    EXPECT_NEAR(all.vx[0], back * (wall.axis == 0 ? 1 : 2), 1e-14) << wall.axis;
    EXPECT_NEAR(all.vy[0], back * (wall.axis == 0 ? 3 : 4), 1e-14) << wall.axis;
    EXPECT_NEAR(all.rho[0], back * (wall.axis == 0 ? 5 : 6), 1e-14) << wall.axis;
  }
}

TEST(SecondOrderSph, ThreadsDoNotChangeABit) {
  const Start start{.velocity = [](const Vec2& x) -> Vec2 { return {std::sin(7 * x.y()), std::cos(5 * x.x())}; }};
  const Samples one = after<SecondOrderMethod>(60, endless(start)),
                three = after<SecondOrderMethod>(60, endless(start), 3);
  EXPECT_EQ(one.x, three.x);
  EXPECT_EQ(one.v, three.v);
  EXPECT_EQ(one.pressure.matrix(), three.pressure.matrix());
}

TEST(SecondOrderSph, RefusesWaterThatDoesNotFillTheDomain) {
  Scene<Newtonian> scene = endless({});
  scene.filled.high.y() = 0.5;
  EXPECT_THROW(SecondOrderMethod::solver(scene), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::sph
