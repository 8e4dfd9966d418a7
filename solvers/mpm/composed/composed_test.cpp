#include "solvers/mpm/composed/composed.hpp"

#include "solvers/forces/uniform.hpp"
#include "solvers/mpm/composed/densities/affine_density.hpp"
#include "solvers/mpm/composed/transfers/apic.hpp"
#include "solvers/mpm/composed/transfers/flip.hpp"
#include "solvers/mpm/composed/transfers/xpic.hpp"
#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/mpm/shapes/b_spline.hpp"
#include "solvers/mpm/shapes/gimp.hpp"
#include "solvers/mpm/testing.hpp"
#include "solvers/testing.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

#include <limits>

namespace touchstone::mpm {
namespace {

/// A method made of parts.
template <class Shape, class Transfer, class Density = CarriedDensity>
struct Of {
  template <class SceneOfRun>
  static auto solver(const SceneOfRun& scene, const Settings& settings) {
    return composed<Shape, Transfer, Density>(scene, settings);
  }
};
using HatFlip = Of<LinearHat, Flip>;
using SplineApic = Of<BSpline<2>, Apic>;

template <class Parts>
class ComposedMpm : public testing::Test {};
using Variants = testing::Types<HatFlip, Of<LinearHat, Xpic<2>>, Of<Gimp, Flip>, SplineApic,
                                Of<BSpline<2>, Xpic<5>, AffineDensity>, Of<BSpline<3>, Xpic<1>>>;
TYPED_TEST_SUITE(ComposedMpm, Variants);

// Each kind of scene takes seconds to compile for each of these methods: theirs all have a uniform force, if only of 0.
const Uniform no_pull{{0, 0}};
Scene<Newtonian, Uniform> unbounded(const Start& start, const Vec2& size = {1, 1}) {
  const Scene<Newtonian> plain = endless(start, size);
  return {plain.domain, plain.fluid, plain.filled, plain.walls, no_pull, plain.start};
}

constexpr Settings dam_settings{.cell = 0.1, .spacing = 0.05, .time_step = 4e-3};

/// Fluid between plates that is driven along them.
Scene<Newtonian, Uniform> channel() {
  return {.domain = {.box = {.high = {0.5, 1}}, .periodic_x = true},
          .fluid = {soft_water, 20},
          .filled = {.high = {0.5, 1}},
          .walls = {floor_at(0, no_slip()), ceiling_at(1, no_slip({0.03, 0}))},
          .body_force = {{0.1, 0}}};
}
constexpr Settings channel_settings{.cell = 0.1, .spacing = 0.05, .time_step = 0.03};

void expect_same_bits(const Samples& a, const Samples& b) {
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_TRUE((a.density == b.density).all());
}

TYPED_TEST(ComposedMpm, CarriesUniformFlowUnchangedAcrossBothPeriodicBoundaries) {
  const Vec2 v(7, -5), size(0.7, 0.9);
  const Scene<Newtonian, Uniform> scene = unbounded(uniform_flow(v), size);
  const Settings settings{.cell = 0.1, .spacing = 0.05, .time_step = 3e-3};
  expect_carried(after<TypeParam>(0, scene, settings), after<TypeParam>(100, scene, settings), v, 0.3, size);
}

TYPED_TEST(ComposedMpm, StartsWithTheVelocityAndThePressureOfItsScene) {
  expect_as_in(varied_start(), after<TypeParam>(0, unbounded(varied_start()), Settings{0.1, 0.05, 1e-3}), 1e-14, 1e-8);
}

TYPED_TEST(ComposedMpm, PutsItsParticlesWhereTheSceneDoes) {
  const Settings settings{.cell = 0.1, .spacing = 0.05, .time_step = 1e-3};
  expect_rearranged(after<TypeParam>(0, unbounded({}), settings),
                    after<TypeParam>(0, unbounded({.places = rearranged}), settings));
}

TYPED_TEST(ComposedMpm, KeepsItsMomentumWithoutWalls) {
  Scene<Tait, Uniform> spinning = drop(no_pull);
  spinning.start.velocity = [](const Vec2& x) -> Vec2 { return {0.4 * x.y() * x.y(), 0.3 * x.x()}; };
  const Settings settings{.cell = 0.1, .spacing = 0.05, .time_step = 0.01};
  const auto momentum = [](const Samples& s) -> Vec2 { return s.v * s.mass.matrix(); };
  const Samples start = after<TypeParam>(0, spinning, settings), end = after<TypeParam>(60, spinning, settings);
  EXPECT_LT((momentum(end) - momentum(start)).norm(), 1e-12 * momentum(start).norm());
  EXPECT_GT(end.pressure.abs().maxCoeff(), 1);  // Pa: forces have been at work
}

TYPED_TEST(ComposedMpm, LeavesStillWaterStill) {
  const Scene<Tait, Uniform> pool{.domain = {.box = {.high = {1, 1}}},
                                  .fluid = soft_water,
                                  .filled = {.high = {0.55, 0.45}},
                                  .walls = {floor_at(0, no_slip()), left_at(0, free_slip())},
                                  .body_force = no_pull};
  const Samples end = after<TypeParam>(20, pool, Settings{.cell = 0.1, .spacing = 0.05, .time_step = 0.01});
  EXPECT_EQ(end.v.norm(), 0);
  EXPECT_EQ(end.density.maxCoeff(), end.density.minCoeff());
}

TYPED_TEST(ComposedMpm, GivesTheSameBitsForAnyNumberOfThreads) {
  Settings of_dam = dam_settings, of_channel = channel_settings;
  const Samples alone = after<TypeParam>(60, dam(1.5), of_dam),
                driven_alone = after<TypeParam>(30, channel(), of_channel);
  for (int threads : {1, 2, 3}) {
    of_dam.threads = of_channel.threads = threads;
    expect_same_bits(after<TypeParam>(60, dam(1.5), of_dam), alone);
    expect_same_bits(after<TypeParam>(30, channel(), of_channel), driven_alone);
  }
}

TYPED_TEST(ComposedMpm, HoldsADamBreakBetweenItsWalls) {
  const Samples s = after<TypeParam>(500, dam(1.5), dam_settings);
  EXPECT_GT(s.x.row(0).maxCoeff(), 0.6);  // by XPIC(1), the slowest, 0.71; by the others 0.8 and more
  EXPECT_GE(s.x.minCoeff(), 0);
  EXPECT_LE(s.x.row(0).maxCoeff(), 1);
}

TEST(ComposedMpm, OfHatsFlipAndMuslIsThePrintedMethod) {
  const auto compare = [](const auto& scene, const Settings& settings, int steps) {
    auto printed = mpm::solver<PrescribedMotion>(scene, settings);
    for (int k = 0; k < steps; ++k) printed.step();
    const Samples expected = printed.samples(), s = after<HatFlip>(steps, scene, settings);
    EXPECT_LT((s.x - expected.x).norm(), 1e-11 * expected.x.norm());
    EXPECT_LT((s.v - expected.v).norm(), 1e-9 * expected.v.norm());
    EXPECT_LT((s.density - expected.density).abs().maxCoeff(), 1e-6);
  };
  compare(channel(), channel_settings, 300);
  compare(dam(1.5), dam_settings, 100);
  compare(endless(shear_wave(1, 0.1)), {.cell = 0.1, .spacing = 0.05, .time_step = 3e-3}, 50);
}

/// The divergence that particles far from the surface feel in a first step, from rest, under a force that pulls the
/// fluid apart [1/s].
template <class Force>
Scalars first_strain(const Force& force) {
  const Settings settings{.cell = 0.1, .spacing = 0.05, .time_step = 0.01};
  const Samples s = after<HatFlip>(1, drop(force), settings);
  Scalars inside((s.x.array() > 0.25 && s.x.array() < 0.75).colwise().all().count());
  for (Index p = 0, k = 0; p < s.size(); ++p)
    if ((s.x.col(p).array() > 0.25 && s.x.col(p).array() < 0.75).all())
      inside[k++] = (soft_water.density / s.density[p] - 1) / settings.time_step;
  return inside;
}

TEST(ComposedMpm, FeelsInAStepWhatItsOwnForcesDo) {
  const auto apart = [](const Vec2& x, double) -> Vec2 { return {3 * x.x(), 0}; };  // 3 1/s²
  EXPECT_LT((first_strain(apart) - 0.03).abs().maxCoeff(), 1e-12);
}

TEST(ComposedMpm, StrainsLessFromNodeToNodeThanItsNodesMove) {
  constexpr double cell = 0.1, k = std::numbers::pi / cell, dt = 0.01;
  const auto to_and_fro = [](const Vec2& x, double) -> Vec2 {  // from node to node
    return {std::cos(k * x.x()), 0};
  };
  const double by_motion = 2 * dt / cell * std::cos(k * cell / 4) / 2;  // of nodes that move as they are pushed
  const double strain = first_strain(to_and_fro).abs().maxCoeff();
  EXPECT_GT(strain, 0);
  EXPECT_LT(strain, 0.7 * by_motion);
}

TEST(ComposedMpm, CountsStepsAndTimeAndTellsItsParts) {
  struct Heard {
    std::vector<SubStep>& parts;
    void operator()(SubStep part) const { parts.push_back(part); }
  };
  auto breaking = SplineApic::solver(dam(1.5), dam_settings);
  std::vector<SubStep> parts;
  breaking.step(Heard{parts});
  breaking.step();
  EXPECT_EQ(parts, (std::vector<SubStep>{SubStep::sorting, SubStep::scatter, SubStep::grid, SubStep::gather,
                                         SubStep::grid, SubStep::gather, SubStep::sorting}));
  EXPECT_EQ(breaking.steps(), 2);
  EXPECT_DOUBLE_EQ(breaking.time(), 2 * 4e-3);
  EXPECT_EQ(breaking.time_step(), 4e-3);
  EXPECT_EQ(breaking.particles(), 8 * 12);
  EXPECT_EQ(breaking.boundary_particles(), 0);
  EXPECT_TRUE(breaking.cell_size().isApprox(Vec2(0.1, 0.1)));
  EXPECT_EQ(breaking.samples().time, breaking.time());
}

TEST(ComposedMpm, StopsWhenFluidLeavesTheDomain) {
  expect_stop_of_a_fall(SplineApic::solver(drop(Uniform{{0, -10}}), {.cell = 0.1, .spacing = 0.1, .time_step = 0.01}));
}

TEST(ComposedMpm, DiagnosesANumberThatIsNotOneInTheStepItAppears) {
  expect_stop_of_spoilt(HatFlip::solver(drop(Spoilt{}), {.cell = 0.1, .spacing = 0.1, .time_step = 0.01}));
}

TEST(ComposedMpm, DiagnosesACollapse) {
  Scene<Tait> squeezed = drop(NoForce{});
  squeezed.start.velocity = [](const Vec2& x) -> Vec2 { return -25 * (x - Vec2(0.5, 0.5)); };
  EXPECT_THROW(after<SplineApic>(20, squeezed, Settings{.cell = 0.1, .spacing = 0.1, .time_step = 0.05}), Diverged);
}

TEST(ComposedMpm, RefusesWallsThatItsShapeCannotHold) {
  Scene<Tait, Uniform> scene = dam(1.5);
  scene.walls[2] = right_at(0.8, free_slip());  // on a grid line, inside the domain
  EXPECT_NO_THROW(HatFlip::solver(scene, dam_settings));
  EXPECT_THROW(SplineApic::solver(scene, dam_settings), std::invalid_argument);
  EXPECT_THROW((Of<Gimp, Flip>::solver(scene, dam_settings)), std::invalid_argument);
  scene.walls[2] = right_at(0.83, free_slip());
  EXPECT_THROW(HatFlip::solver(scene, dam_settings), std::invalid_argument);
}

TEST(ComposedMpm, RefusesSettingsThatAreNotPositive) {
  for (double Settings::*setting : {&Settings::cell, &Settings::spacing, &Settings::time_step}) {
    Settings wrong = dam_settings;
    wrong.*setting = 0;
    EXPECT_THROW(SplineApic::solver(dam(1.5), wrong), std::invalid_argument);
  }
  Settings threadless = dam_settings;
  threadless.threads = 0;
  EXPECT_THROW(SplineApic::solver(dam(1.5), threadless), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::mpm
