/// How runs start and how they repeat along both axes, for all methods of this room.

#include "solvers/mpm/affine/affine.hpp"
#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/testing.hpp"

#include <numbers>

namespace touchstone::mpm {
namespace {

/// `left_by_damping` is what a method's own damping leaves in so many steps of a wave whose number is `k_cell` per
/// cell.
struct Printed {
  static double left_by_damping(double /*k_cell*/, int /*steps*/) { return 1; }
  static auto solver(const Scene<Newtonian>& scene, const Settings& settings) {
    return mpm::solver<PrescribedMotion>(scene, settings);
  }
};
struct SinglePrinted {
  static auto solver(const Scene<Newtonian>& scene, const Settings& settings) {
    return mpm::solver<PrescribedMotion, float>(scene, settings);
  }
};
struct AffineMethod {
  static double left_by_damping(double k_cell, int steps) { return std::exp(-std::pow(k_cell, 4) / 40 * steps); }
  static auto solver(const Scene<Newtonian>& scene, const Settings& settings) { return affine(scene, settings); }
};

constexpr Settings coarse{.cell = 0.1, .spacing = 0.05, .time_step = 1e-3};

template <class Method>
class MpmStart : public testing::Test {};
using Methods = testing::Types<Printed, AffineMethod>;
TYPED_TEST_SUITE(MpmStart, Methods);

TYPED_TEST(MpmStart, ARunHasTheVelocityAndThePressureOfItsScene) {
  expect_as_in(varied_start(), after<TypeParam>(0, endless(varied_start()), coarse), 1e-14, 1e-8);
}

TYPED_TEST(MpmStart, ARunWithoutAWordIsAtRest) {
  const Samples s = after<TypeParam>(0, endless({}), coarse);
  EXPECT_EQ(s.v.norm(), 0);
  EXPECT_EQ(s.pressure.abs().maxCoeff(), 0);
}

TYPED_TEST(MpmStart, ASceneMayPutItsParticlesElsewhere) {
  expect_rearranged(after<TypeParam>(0, endless({}), coarse),
                    after<TypeParam>(0, endless({.places = rearranged}), coarse));
}

TYPED_TEST(MpmStart, RefusesAParticleOutsideTheDomainAndNoneAtAll) {
  const auto outside = [](const Vectors& lattice) -> Vectors { return 2 * lattice; };
  const auto none = [](const Vectors&) { return Vectors(2, 0); };
  EXPECT_THROW(after<TypeParam>(0, endless({.places = outside}), coarse), std::invalid_argument);
  EXPECT_THROW(after<TypeParam>(0, endless({.places = none}), coarse), std::invalid_argument);
}

TYPED_TEST(MpmStart, UniformFlowCrossesBothPeriodicBoundariesUnchanged) {
  const Vec2 v(7, -5), size(0.7, 0.9);
  const Scene<Newtonian> scene = endless(uniform_flow(v), size);
  expect_carried(after<TypeParam>(0, scene, coarse), after<TypeParam>(1000, scene, coarse), v, 1, size);
}

TYPED_TEST(MpmStart, AShearWaveDecaysAlikeAlongBothAxes) {
  const Settings settings{.cell = 0.05, .spacing = 0.025, .time_step = 2e-3};
  const auto left_of_wave = [&](int axis) {
    return amplitude_of_wave(after<TypeParam>(500, endless(shear_wave(axis, 0.1)), settings), axis) / 0.1;
  };
  EXPECT_NEAR(left_of_wave(0), left_of_wave(1), 1e-9);
  constexpr double k = 2 * std::numbers::pi;
  const double expected =
      std::exp(-oil.kinematic_viscosity() * k * k) * TypeParam::left_by_damping(k * settings.cell, 500);
  EXPECT_NEAR(left_of_wave(0), expected, 0.03 * expected);
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
  expect_as_in(varied_start(), after<SinglePrinted>(0, endless(varied_start()), coarse), 1e-6, 0.02);
}

}  // namespace
}  // namespace touchstone::mpm
