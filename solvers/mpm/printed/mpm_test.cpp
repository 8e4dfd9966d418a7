#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/mpm/testing.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::mpm {
namespace {

constexpr Settings dam_settings{.cell = 0.1, .spacing = 0.04, .time_step = 4e-3};

Vec2 momentum(const Samples& s) { return s.v * s.mass.matrix(); }

template <class Solver>
void run(Solver& simulation, int steps) {
  for (int step = 0; step < steps; ++step) simulation.step();
}

TEST(Mpm, KeepsItsMomentumWithoutWalls) {
  auto spinning = solver<PrescribedMotion>(drop(Blow{[](const Vec2& x) -> Vec2 {
                                             return {40 * x.y() * x.y(), 30 * x.x()};
                                           }}),
                                           {.cell = 0.1, .spacing = 0.04, .time_step = 0.01});
  spinning.step();
  const Vec2 start = momentum(spinning.samples());
  run(spinning, 100);
  const Samples end = spinning.samples();
  EXPECT_LT((momentum(end) - start).norm(), 1e-12 * start.norm());
  EXPECT_GT(end.pressure.abs().maxCoeff(), 1);  // Pa: forces have been at work
}

TEST(Mpm, GainsTheMomentumThatItsForceGives) {
  auto falling = solver<VelocityReset>(drop(Uniform{{2, -3}}), {.cell = 0.1, .spacing = 0.05, .time_step = 1e-3});
  run(falling, 200);
  const Samples end = falling.samples();
  EXPECT_TRUE(momentum(end).isApprox(1000 * 0.2 * Vec2(2, -3), 1e-12));
  EXPECT_LT((end.v.colwise() - 0.2 * Vec2(2, -3)).norm(), 1e-12);
}

TEST(Mpm, FeelsAForceAtItsParticlesAsItFeelsTheSameForceEverywhere) {
  const auto gravity = [](const Vec2&, double) -> Vec2 { return {0, -1}; };
  const Scene<Tait, Uniform> scene = dam();
  Settings off_grid_lines = dam_settings;  // on one, rounding decides which cell's gradient a particle feels
  off_grid_lines.spacing = 0.05;
  auto uniform = solver<PrescribedMotion>(scene, off_grid_lines);
  auto local = solver<PrescribedMotion>(
      Scene<Tait, decltype(gravity)>{scene.domain, scene.fluid, scene.filled, scene.walls, gravity}, off_grid_lines);
  run(uniform, 100);
  run(local, 100);
  EXPECT_TRUE(local.samples().v.isApprox(uniform.samples().v, 1e-9));
}

TEST(Mpm, CarriesUniformFlowUnchangedAcrossTheSeam) {
  constexpr double dt = 0.01;
  const Vec2 v(9, 0.2);  // m/s: 0.9 cells per step along x
  const Blow start{[=](const Vec2&) -> Vec2 { return v / dt; }};
  auto stream = solver<PrescribedMotion>(
      Scene<Newtonian, decltype(start)>{.domain = {.box = {.high = {0.7, 1}}, .periodic_x = true},
                                        .fluid = {soft_water, 1e-3},
                                        .filled = {.low = {0, 0.2}, .high = {0.7, 0.6}},
                                        .body_force = start},
      {.cell = 0.1, .spacing = 0.03, .time_step = dt});
  const Samples at_rest = stream.samples();
  run(stream, 150);
  const Samples end = stream.samples();
  EXPECT_LT((end.v.colwise() - v).norm(), 1e-10);
  EXPECT_LT((end.density - 1000).abs().maxCoeff(), 1e-8);
  const Vectors way = end.x - at_rest.x;
  EXPECT_LT((way.row(1).array() - 1.5 * 0.2).abs().maxCoeff(), 1e-11);
  const Scalars periods = (1.5 * 9 - way.row(0).array()) / 0.7;
  EXPECT_LT((periods - periods.round()).abs().maxCoeff(), 1e-10);
}

TEST(Mpm, LeavesStillWaterStill) {
  Scene<Tait> pool{.domain = {.box = {.high = {1, 1}}}, .fluid = soft_water, .filled = {.high = {0.55, 0.45}}};
  pool.walls = {floor_at(0, no_slip()), left_at(0, free_slip())};
  auto still = solver<VelocityReset>(pool, {.cell = 0.1, .spacing = 0.03, .time_step = 0.01});
  run(still, 50);
  EXPECT_EQ(still.samples().v.norm(), 0);
  EXPECT_EQ(still.samples().density.maxCoeff(), still.samples().density.minCoeff());
}

TEST(Mpm, RestsOnItsFloor) {
  Scene<Newtonian, Uniform> pool{.domain = {.box = {.high = {0.5, 0.6}}, .periodic_x = true},
                                 .fluid = {soft_water, 40},
                                 .filled = {.high = {0.5, 0.5}},
                                 .walls = {floor_at(0, no_slip())},
                                 .body_force = {{0, -0.02}}};
  auto resting = solver<PrescribedMotion>(pool, {.cell = 0.05, .spacing = 0.025, .time_step = 5e-3});
  run(resting, 4000);
  const Samples end = resting.samples();
  const Scalars weight_above = 1000 * 0.02 * (0.5 - end.x.row(1).array()).transpose();  // Pa
  EXPECT_LT(end.v.colwise().norm().maxCoeff(), 1e-4);
  EXPECT_LT((end.pressure - weight_above).abs().maxCoeff(), 0.1 * weight_above.maxCoeff());
}

TEST(Mpm, KeepsAllParticlesOfADamBreakInTheTank) {
  auto breaking = solver<PrescribedMotion>(dam(), dam_settings);
  run(breaking, 600);
  const Samples end = breaking.samples();
  EXPECT_GT(end.x.row(0).maxCoeff(), 0.9);  // the front has reached the far wall
  EXPECT_GE(end.x.minCoeff(), 0);
  EXPECT_LE(end.x.row(0).maxCoeff(), 1);
}

TEST(Mpm, RunsTwiceToTheSameBits) {
  auto one = solver<VelocityReset>(dam(), dam_settings);
  auto other = solver<VelocityReset>(dam(), dam_settings);
  run(one, 400);
  run(other, 400);
  EXPECT_EQ(one.samples().x, other.samples().x);
  EXPECT_EQ(one.samples().v, other.samples().v);
  EXPECT_TRUE((one.samples().pressure == other.samples().pressure).all());
}

/// The same bits after some steps, for one thread and for more.
template <class Force, class FluidLaw>
void expect_same_bits(const Scene<FluidLaw, Force>& scene, Settings settings, int steps) {
  auto one = solver<PrescribedMotion>(scene, settings);
  run(one, steps);
  const Samples expected = one.samples();
  for (int threads : {2, 3}) {
    settings.threads = threads;
    auto shared = solver<PrescribedMotion>(scene, settings);
    run(shared, steps);
    const Samples s = shared.samples();
    EXPECT_EQ(s.x, expected.x) << threads;
    EXPECT_EQ(s.v, expected.v) << threads;
    EXPECT_TRUE((s.density == expected.density).all()) << threads;
  }
}

TEST(Mpm, GivesTheSameBitsForAnyNumberOfThreads) {
  expect_same_bits(dam(), dam_settings, 400);
  expect_same_bits(Scene<Newtonian, Uniform>{.domain = {.box = {.high = {0.6, 0.9}}, .periodic_x = true},
                                             .fluid = {soft_water, 20},
                                             .filled = {.high = {0.6, 0.9}},
                                             .walls = {floor_at(0, no_slip()), ceiling_at(0.9, no_slip())},
                                             .body_force = {{1, 0}}},
                   {.cell = 0.1, .spacing = 0.05, .time_step = 5e-3}, 300);
}

TEST(Mpm, NamesTheSameFaultForAnyNumberOfThreads) {
  std::string faults[2];
  for (int threads : {1, 2}) try {
      auto falling = solver<PrescribedMotion>(drop(Uniform{{0, -10}}),
                                              {.cell = 0.1, .spacing = 0.05, .time_step = 0.01, .threads = threads});
      run(falling, 200);
    } catch (const Diverged& diverged) {
      faults[threads - 1] = diverged.what();
    }
  EXPECT_NE(faults[0], "");
  EXPECT_EQ(faults[0], faults[1]);
}

TEST(Mpm, FindsItsWayWhereTheBackgroundIsEmpty) {
  Scene<Tait, Uniform> wide = dam();
  wide.domain.box.high = {20, 40};
  wide.walls[2] = right_at(20, free_slip());
  auto in_a_tank = solver<PrescribedMotion>(dam(), dam_settings);
  auto in_a_lake = solver<PrescribedMotion>(wide, dam_settings);
  run(in_a_tank, 60);  // before the far wall is reached
  run(in_a_lake, 60);
  EXPECT_TRUE(in_a_lake.samples().v.isApprox(in_a_tank.samples().v, 1e-9));
}

TEST(Mpm, InSinglePrecisionComesCloseToDouble) {
  const Scene<Newtonian, Uniform> channel{.domain = {.box = {.high = {0.5, 1}}, .periodic_x = true},
                                          .fluid = {soft_water, 20},
                                          .filled = {.high = {0.5, 1}},
                                          .walls = {floor_at(0, no_slip()), ceiling_at(1, no_slip())},
                                          .body_force = {{0.1, 0}}};
  const Settings settings{.cell = 0.1, .spacing = 0.05, .time_step = 5e-3};
  auto fine = solver<PrescribedMotion>(channel, settings);
  auto coarse = solver<PrescribedMotion, float>(channel, settings);
  run(fine, 500);
  run(coarse, 500);
  EXPECT_TRUE(coarse.samples().v.isApprox(fine.samples().v, 1e-5));
  EXPECT_TRUE(coarse.samples().density.isApprox(fine.samples().density, 1e-6));
}

TEST(Mpm, TellsWhichPartOfAStepIsDone) {
  struct Heard {
    std::vector<SubStep>& parts;
    void operator()(SubStep part) const { parts.push_back(part); }
  };
  std::vector<SubStep> parts;
  auto breaking = solver<PrescribedMotion>(dam(), dam_settings);
  breaking.step(Heard{parts});
  EXPECT_EQ(parts, (std::vector<SubStep>{SubStep::scatter, SubStep::grid, SubStep::gather, SubStep::sorting}));
}

TEST(Mpm, CountsStepsAndTime) {
  auto breaking = solver<PrescribedMotion>(dam(), dam_settings);
  run(breaking, 3);
  EXPECT_EQ(breaking.steps(), 3);
  EXPECT_DOUBLE_EQ(breaking.time(), 3 * 4e-3);
  EXPECT_EQ(breaking.time_step(), 4e-3);
  EXPECT_TRUE(breaking.cell_size().isApprox(Vec2(0.1, 0.1)));
  EXPECT_EQ(breaking.samples().time, breaking.time());
}

TEST(Mpm, StopsWhenFluidLeavesTheDomain) {
  expect_stop_of_a_fall(
      solver<PrescribedMotion>(drop(Uniform{{0, -10}}), {.cell = 0.1, .spacing = 0.1, .time_step = 0.01}));
}

TEST(Mpm, DiagnosesANumberThatIsNotOneInTheStepItAppears) {
  // In one step number 99 spoils two cells on every side: (16), then (18).
  expect_stop_of_spoilt(solver<PrescribedMotion>(drop(Spoilt{}), {.cell = 0.1, .spacing = 0.1, .time_step = 0.01}), 77);
}

TEST(Mpm, DiagnosesACollapse) {
  auto squeezed =
      solver<PrescribedMotion>(drop(Blow{[](const Vec2& x) -> Vec2 { return -500 * (x - Vec2(0.5, 0.5)); }}),
                               {.cell = 0.1, .spacing = 0.1, .time_step = 0.05});
  EXPECT_THROW(run(squeezed, 20), Diverged);
}

}  // namespace
}  // namespace touchstone::mpm
