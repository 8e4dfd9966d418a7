/// Runs of the printed method and of that with a transport velocity, with their variants.

#include "solvers/forces/force_field.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/integrators/adams_bashforth.hpp"
#include "solvers/integrators/kick_drift_kick.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "solvers/sph/transport_velocity/transport_velocity.hpp"
#include "solvers/testing.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

namespace touchstone::sph {
namespace runs_test {

constexpr double spacing = 0.025 * mm, h = 1.2 * spacing, height = 0.5 * mm;
const Box box{.high = {0.4 * mm, height}};
const Scene<Newtonian, Uniform> channel{.domain = {.box = box, .periodic_x = true},
                                        .fluid = {{.density = 1000, .bulk_modulus = 143}, 1e-3},
                                        .filled = box,
                                        .walls = {floor_at(0, no_slip()), ceiling_at(height, no_slip({0.01, 0}))},
                                        .body_force = {{8e-3, 0}}};

auto all_terms() {
  return momentum(Pressure{}, LaminarViscosity{.nu = 1e-6, .eta = 0.1 * h},
                  ArtificialViscosity{.alpha = 0.01, .sound_speed = 1, .h = h});
}
auto regular_terms() { return momentum(PressureDifference{}, MorrisViscosity{.mu = 1e-3}); }

template <class Solver>
Samples run(Solver solver, int steps) {
  for (int k = 0; k < steps; ++k) solver.step();
  return solver.samples();
}
template <class Integrator = PredictorCorrector, class Real = double, class Left = Without<>>
Samples after_printed(int steps, int threads = 1) {
  return run(printed<CubicSpline, Integrator, Real, Left>(channel, {spacing, h, 5 * us, threads}, all_terms()), steps);
}
template <class Integrator = KickDriftKick, class Real = double, class Left = Without<>>
Samples after_transport(int steps, int threads = 1) {
  return run(transport_velocity<QuinticSpline, Integrator, Real, Left>(channel, {spacing, spacing, 10 * us, threads},
                                                                       regular_terms()),
             steps);
}

void expect_equal(const Samples& a, const Samples& b) {
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_TRUE((a.density == b.density).all());
}
double gap(const Samples& a, const Samples& b) { return (a.v - b.v).norm() / b.v.norm(); }

TEST(Threads, AnyNumberOfThemGivesTheSameBits) {
  const Samples one = after_printed<AdamsBashforth>(10), other = after_transport(10);
  for (const int threads : {2, 3}) {
    expect_equal(after_printed<AdamsBashforth>(10, threads), one);
    expect_equal(after_transport(10, threads), other);
  }
}

TEST(Threads, MustBeSome) {
  EXPECT_THROW(printed<CubicSpline>(channel, {spacing, h, 5 * us, 0}, all_terms()), std::invalid_argument);
}

TEST(Precision, SinglePrecisionStaysNearDouble) {
  EXPECT_LT((gap(after_printed<AdamsBashforth, float>(200), after_printed<AdamsBashforth>(200))), 1e-3);
  EXPECT_LT((gap(after_transport<AdamsBashforth, float>(200), after_transport<AdamsBashforth>(200))), 1e-3);
}

TEST(Integrators, AgreeOnAFlowThatTheyResolve) {
  const Samples printed_flow = after_printed<PredictorCorrector>(400);
  EXPECT_LT(gap(after_printed<AdamsBashforth>(400), printed_flow), 1e-3);
  EXPECT_LT(gap(after_printed<KickDriftKick>(400), printed_flow), 1e-3);
  EXPECT_LT(gap(after_transport<AdamsBashforth>(200), after_transport<KickDriftKick>(200)), 2e-3);
}

TEST(Without, DensityReinitialisationIsLeftOutAndNothingElse) {
  using Left = Without<DensityReinitialisation>;
  expect_equal(after_printed<PredictorCorrector, double, Left>(29), after_printed(29));
  EXPECT_GT(gap(after_printed<PredictorCorrector, double, Left>(60), after_printed(60)), 0);
}

TEST(Without, RepulsionIsLeftOutAndNothingElse) {
  // in so few steps nothing comes closer to a wall than it was, but by rounding
  const auto push = [](int steps) {
    return gap(after_printed<PredictorCorrector, double, Without<Repulsion>>(steps), after_printed(steps));
  };
  EXPECT_LT(push(2), 1e-9);
  EXPECT_GT(push(100), 0);
}

TEST(Without, VolumeConstraintIsLeftOutAndNothingElse) {
  using Left = Without<VolumeConstraint>;
  expect_equal(after_transport<KickDriftKick, double, Left>(29), after_transport(29));
  const auto volume = [](const Samples& samples) { return samples.volumes().sum() / (0.4 * mm * height) - 1; };
  EXPECT_NEAR(volume(after_transport(300)), 0, 1e-12);
  EXPECT_GT(std::abs(volume(after_transport<KickDriftKick, double, Left>(300))), 1e-12);
}

TEST(Without, BackgroundPressureTakesTheDriftMomentumWithIt) {
  expect_equal(after_transport<KickDriftKick, double, Without<BackgroundPressure>>(100),
               after_transport<KickDriftKick, double, Without<BackgroundPressure, DriftMomentum>>(100));
  EXPECT_GT(gap(after_transport<KickDriftKick, double, Without<BackgroundPressure>>(100), after_transport(100)), 0);
  EXPECT_GT(gap(after_transport<KickDriftKick, double, Without<DriftMomentum>>(100), after_transport(100)), 0);
}

/// The channel with other walls.
Scene<Newtonian, Uniform> between(const WallVelocity& low, const WallVelocity& high, const Vec2& force = {8e-3, 0}) {
  Scene<Newtonian, Uniform> scene = channel;
  scene.walls = {floor_at(0, low), ceiling_at(height, high)};
  scene.body_force = {force};
  return scene;
}
const Scene<Newtonian, Uniform> falling = between(free_slip(), free_slip());
const Settings settings{.spacing = spacing, .smoothing_length = h, .time_step = 5 * us};

TEST(Printed, FluidBetweenSlippingWallsFallsFreelyAcrossThePeriodicBoundary) {
  auto solver = printed<CubicSpline>(falling, settings, all_terms());
  for (int k = 0; k < 400; ++k) solver.step();
  const Samples samples = solver.samples();
  EXPECT_NEAR(samples.v.row(0).minCoeff(), 8e-3 * solver.time(), 1e-12);
  EXPECT_NEAR(samples.v.row(0).maxCoeff(), 8e-3 * solver.time(), 1e-12);
}

TEST(Printed, SamplesStandWithinThePeriodAlsoWhereTheFluidHasJustLeftIt) {
  auto stream = between(free_slip(), free_slip());
  stream.start = uniform_flow({0.1, 0});
  auto solver = printed<CubicSpline>(stream, settings, all_terms());
  for (int k = 0; k < 60; ++k) {  // the first column crosses the boundary in step 25
    solver.step();
    const Samples samples = solver.samples();
    ASSERT_GE(samples.x.row(0).minCoeff(), 0) << k;
    ASSERT_LT(samples.x.row(0).maxCoeff(), stream.domain.box.high.x()) << k;
  }
}

TEST(TransportVelocity, FluidBetweenSlippingWallsFallsFreelyAcrossThePeriodicBoundary) {
  auto solver = transport_velocity<QuinticSpline>(falling, {spacing, spacing, 5 * us}, regular_terms());
  for (int k = 0; k < 100; ++k) solver.step();  // before the square lattice turns into a denser one
  const Samples samples = solver.samples();
  EXPECT_NEAR(samples.v.row(0).minCoeff(), 8e-3 * solver.time(), 1e-9);
  EXPECT_NEAR(samples.v.row(0).maxCoeff(), 8e-3 * solver.time(), 1e-9);
}

TEST(Printed, StillWaterStaysStill) {
  auto still = printed<CubicSpline>(between(no_slip(), no_slip(), {0, 0}), settings, all_terms());
  EXPECT_LT(run(still, 200).v.cwiseAbs().maxCoeff(), 1e-12);
}

TEST(TransportVelocity, TwoRunsAreBitEqual) { expect_equal(after_transport(300), after_transport(300)); }

TEST(TransportVelocity, DriftsForAStepByWhatABackgroundPressureDoesInHalfOfOne) {
  // Adami, Hu & Adams (2013), eq. 13, on two particles at rest: -(p_b / m) (V_i² + V_j²) dW/dr, p_b = 0.1 rho c².
  constexpr double dt = 1e-7, apart = 1.3 * spacing;
  Scene<Newtonian> two{.domain = {.box = box}, .fluid = channel.fluid, .filled = box};
  two.start.places = [](const Vectors&) { return Vectors{{0.2 * mm, 0.2 * mm + apart}, {0.2 * mm, 0.2 * mm}}; };
  const auto after = [&](int steps) {
    const auto terms = regular_terms();
    return run(transport_velocity<QuinticSpline>(two, {spacing, spacing, dt}, terms), steps);
  };
  EXPECT_EQ(after(1).x, after(0).x) << "nothing drives a drift yet";
  const double rho = channel.fluid.density, c = channel.fluid.sound_speed(), mass = rho * spacing * spacing;
  const double slope = Slope<QuinticSpline>(spacing)(apart, 1.0);
  const double expected = -0.1 * rho * c * c * mass * 2 / (rho * rho) * slope * dt * dt / 2;
  const Samples moved = after(2);
  EXPECT_NEAR((moved.x(0, 1) - moved.x(0, 0) - apart) / (2 * expected), 1, 1e-5);
  EXPECT_GT(expected, 0);
}

TEST(TransportVelocity, KeepsTheVolumeOfItsFluid) {
  auto solver = transport_velocity<QuinticSpline>(falling, {spacing, spacing, 5 * us}, regular_terms());
  for (int k = 0; k < 300; ++k) solver.step();
  EXPECT_NEAR(solver.samples().volumes().sum(), 0.4 * mm * height, 1e-12 * 0.4 * mm * height);
}

TEST(Printed, RefusesAPeriodShorterThanItsListsAndWallsOffTheDomain) {
  Scene<Newtonian, Uniform> narrow = falling;
  narrow.domain.box.high.x() = narrow.filled.high.x() = 2 * spacing;
  EXPECT_THROW(printed<CubicSpline>(narrow, settings, all_terms()), std::invalid_argument);
  Scene<Newtonian, Uniform> raised = falling;
  raised.walls[0].position = 0.1 * height;
  EXPECT_THROW(printed<CubicSpline>(raised, settings, all_terms()), std::invalid_argument);
}

TEST(Printed, TwoRunsAreBitEqual) { expect_equal(after_printed(300), after_printed(300)); }

/// A force that is no number for one particle from a time on.
ForceField poison(const Vec2& at, double from) {
  return {[=](const Vec2& x, double time) -> Vec2 {
    return time >= from && (x - at).norm() < 0.2 * spacing ? Vec2(0, std::nan("")) : Vec2(0, 0);
  }};
}

TEST(Printed, AParticleThatIsNoNumberIsNamedWithItsStep) {
  const Vec2 at(3.5 * spacing, 4.5 * spacing);  // column 3 of row 4: number 4 * 16 + 3
  const Scene<Newtonian, ForceField> scene{channel.domain, channel.fluid, channel.filled, channel.walls,
                                           poison(at, 20 * us)};
  auto solver = printed<CubicSpline>(scene, settings, all_terms());
  try {
    for (int k = 0; k < 100; ++k) solver.step();
    FAIL() << "expected Diverged";
  } catch (const Diverged& diverged) {
    EXPECT_EQ(diverged.fault.particle, 67);
    EXPECT_EQ(diverged.fault.step, 5);  // poisoned in the step from 20 us on, which is the fifth
    EXPECT_TRUE(std::isnan(diverged.fault.value));
  }
}

TEST(Printed, RefusesSettingsThatAreNoNumbersOfTheirKind) {
  const auto make = [](Settings bad) { return printed<CubicSpline>(falling, bad, all_terms()); };
  EXPECT_THROW(make({-spacing, h, 5 * us}), std::invalid_argument);
  EXPECT_THROW(make({spacing, 0, 5 * us}), std::invalid_argument);
  EXPECT_THROW(make({spacing, h, std::nan("")}), std::invalid_argument);
  EXPECT_THROW(make({10 * mm, h, 5 * us}), std::invalid_argument);  // larger than the box
}

constexpr double coarse = 0.05;  // m

struct PrintedMethod {
  static auto solver(const Scene<Newtonian>& scene, int threads = 1) {
    const double length = 1.2 * coarse;
    return printed<CubicSpline>(
        scene, {.spacing = coarse, .smoothing_length = length, .time_step = 1e-3, .threads = threads},
        momentum(Pressure{}, LaminarViscosity{.nu = oil.kinematic_viscosity(), .eta = 0.1 * length},
                 ArtificialViscosity{.alpha = 0, .sound_speed = oil.sound_speed(), .h = length}));
  }
};
struct TransportMethod {
  static auto solver(const Scene<Newtonian>& scene, int threads = 1) {
    return transport_velocity<QuinticSpline>(
        scene, {.spacing = coarse, .smoothing_length = coarse, .time_step = 1e-3, .threads = threads},
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

}  // namespace runs_test
}  // namespace touchstone::sph
