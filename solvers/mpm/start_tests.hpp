#pragma once
/// How runs start and how they repeat along both axes, for each method that keeps its particles in cells. A `Method`
/// has solver(scene, settings) and left_by_damping(k_cell, steps), what its own damping leaves in so many steps of a
/// wave whose number is `k_cell` per cell.

#include "solvers/mpm/simulation.hpp"
#include "solvers/testing.hpp"

namespace touchstone::mpm {

inline constexpr Settings start_settings{.cell = 0.1, .spacing = 0.05, .time_step = 1e-3};

template <class Method>
class MpmStart : public testing::Test {};
TYPED_TEST_SUITE_P(MpmStart);

TYPED_TEST_P(MpmStart, ARunHasTheVelocityAndThePressureOfItsScene) {
  expect_as_in(varied_start(), after<TypeParam>(0, endless(varied_start()), start_settings), 1e-14, 1e-8);
}

TYPED_TEST_P(MpmStart, ItsExtremesAreThoseOfTheFastestAndOfTheDensestParticle) {
  const auto run = TypeParam::solver(endless(varied_start()), start_settings);
  const Samples s = run.samples();
  ASSERT_LT(s.density.minCoeff(), s.density.maxCoeff());
  EXPECT_NEAR(run.extremes().speed, s.v.colwise().norm().maxCoeff(), 1e-12);
  EXPECT_NEAR(run.extremes().density, s.density.maxCoeff(), 1e-9);
}

TYPED_TEST_P(MpmStart, ARunWithoutAWordIsAtRest) {
  const Samples s = after<TypeParam>(0, endless({}), start_settings);
  EXPECT_EQ(s.v.norm(), 0);
  EXPECT_EQ(s.pressure.abs().maxCoeff(), 0);
}

TYPED_TEST_P(MpmStart, ASceneMayPutItsParticlesElsewhere) {
  expect_rearranged(after<TypeParam>(0, endless({}), start_settings),
                    after<TypeParam>(0, endless({.places = rearranged}), start_settings));
}

TYPED_TEST_P(MpmStart, RefusesAParticleOutsideTheDomainAndNoneAtAll) {
  const auto outside = [](const Vectors& lattice) -> Vectors { return 2 * lattice; };
  const auto none = [](const Vectors&) { return Vectors(2, 0); };
  EXPECT_THROW(after<TypeParam>(0, endless({.places = outside}), start_settings), std::invalid_argument);
  EXPECT_THROW(after<TypeParam>(0, endless({.places = none}), start_settings), std::invalid_argument);
}

TYPED_TEST_P(MpmStart, UniformFlowCrossesBothPeriodicBoundariesUnchanged) {
  const Vec2 v(7, -5), size(0.7, 0.9);
  const Scene<Newtonian> scene = endless(uniform_flow(v), size);
  expect_carried(after<TypeParam>(0, scene, start_settings), after<TypeParam>(1000, scene, start_settings), v, 1, size);
}

TYPED_TEST_P(MpmStart, AShearWaveDecaysAlikeAlongBothAxes) {
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

TYPED_TEST_P(MpmStart, ThreadsDoNotChangeABitWhereRowsRepeat) {
  const Start start{.velocity = [](const Vec2& x) -> Vec2 { return {std::sin(7 * x.y()), std::cos(5 * x.x())}; }};
  Settings settings{.cell = 0.05, .spacing = 0.02, .time_step = 1e-3};
  const Samples one = after<TypeParam>(100, endless(start), settings);
  settings.threads = 3;
  const Samples three = after<TypeParam>(100, endless(start), settings);
  EXPECT_EQ(one.x, three.x);
  EXPECT_EQ(one.v, three.v);
}

REGISTER_TYPED_TEST_SUITE_P(MpmStart, ARunHasTheVelocityAndThePressureOfItsScene,
                            ItsExtremesAreThoseOfTheFastestAndOfTheDensestParticle, ARunWithoutAWordIsAtRest,
                            ASceneMayPutItsParticlesElsewhere, RefusesAParticleOutsideTheDomainAndNoneAtAll,
                            UniformFlowCrossesBothPeriodicBoundariesUnchanged, AShearWaveDecaysAlikeAlongBothAxes,
                            ThreadsDoNotChangeABitWhereRowsRepeat);

}  // namespace touchstone::mpm
