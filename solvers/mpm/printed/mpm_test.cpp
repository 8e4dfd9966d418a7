#include "solvers/mpm/printed/mpm.hpp"

#include "solvers/mpm/plain/plain.hpp"
#include "solvers/mpm/start_tests.hpp"
#include "solvers/mpm/testing.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/navier_slip.hpp"
#include "solvers/walls/no_slip.hpp"

#include <limits>

namespace touchstone::mpm {
namespace {

template <class Number>
struct PrintedMethod {
  static double left_by_damping(double /*k_cell*/, int /*steps*/) { return 1; }
  static auto solver(const Scene<Newtonian>& scene, const Settings& settings) {
    return mpm::printed<PrescribedMotion, Number>(scene, settings);
  }
};
INSTANTIATE_TYPED_TEST_SUITE_P(Printed, MpmStart, PrintedMethod<double>);

TEST(MpmStartInSinglePrecision, HasTheVelocityAndThePressureOfItsScene) {
  const auto started = PrintedMethod<float>::solver(endless(varied_start()), start_settings);
  expect_as_in(varied_start(), started.samples(), 1e-6, 0.02);
}

constexpr Settings dam_settings{.cell = 0.1, .spacing = 0.04, .time_step = 4e-3};

Vec2 momentum(const Samples& s) { return s.v * s.mass.matrix(); }

template <class Solver>
void run(Solver& simulation, int steps) {
  for (int step = 0; step < steps; ++step) simulation.step();
}

TEST(Mpm, KeepsItsMomentumWithoutWalls) {
  auto spinning = printed<PrescribedMotion>(drop(blow([](const Vec2& x) -> Vec2 {
                                             return {40 * x.y() * x.y(), 30 * x.x()};
                                           })),
                                           {.cell = 0.1, .spacing = 0.04, .time_step = 0.01});
  spinning.step();
  const Vec2 start = momentum(spinning.samples());
  run(spinning, 100);
  const Samples end = spinning.samples();
  EXPECT_LT((momentum(end) - start).norm(), 1e-12 * start.norm());
  EXPECT_GT(end.pressure.abs().maxCoeff(), 1);  // Pa: forces have been at work
}

TEST(Mpm, GainsTheMomentumThatItsForceGives) {
  auto falling = printed<PrescribedMotion>(drop(Uniform{{2, -3}}), {.cell = 0.1, .spacing = 0.05, .time_step = 1e-3});
  run(falling, 200);
  const Samples end = falling.samples();
  EXPECT_TRUE(momentum(end).isApprox(1000 * 0.2 * Vec2(2, -3), 1e-12));
  EXPECT_LT((end.v.colwise() - 0.2 * Vec2(2, -3)).norm(), 1e-12);
}

TEST(Mpm, FeelsAForceAtItsParticlesAsItFeelsTheSameForceEverywhere) {
  const ForceField gravity{[](const Vec2&, double) -> Vec2 { return {0, -1}; }};
  const Scene<Tait, Uniform> scene = dam();
  Settings off_grid_lines = dam_settings;  // on one, rounding decides which cell's gradient a particle feels
  off_grid_lines.spacing = 0.05;
  auto uniform = printed<PrescribedMotion>(scene, off_grid_lines);
  auto local = printed<PrescribedMotion>(
      Scene<Tait, ForceField>{scene.domain, scene.fluid, scene.filled, scene.walls, gravity}, off_grid_lines);
  run(uniform, 100);
  run(local, 100);
  EXPECT_TRUE(local.samples().v.isApprox(uniform.samples().v, 1e-9));
}

TEST(Mpm, CarriesUniformFlowUnchangedAcrossThePeriodicBoundary) {
  const Vec2 v(9, 0.2);  // m/s: 0.9 cells per step along x
  auto stream =
      printed<PrescribedMotion>(Scene<Newtonian, Uniform>{.domain = {.box = {.high = {0.7, 1}}, .periodic_x = true},
                                                         .fluid = {soft_water, 1e-3},
                                                         .filled = {.low = {0, 0.2}, .high = {0.7, 0.6}},
                                                         .body_force = {{0, 0}},
                                                         .start = {.velocity = [=](const Vec2&) { return v; }}},
                               {.cell = 0.1, .spacing = 0.03, .time_step = 0.01});
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
  const Scene<Tait, Uniform> pool{.domain = {.box = {.high = {1, 1}}},
                                  .fluid = soft_water,
                                  .filled = {.high = {0.55, 0.45}},
                                  .walls = {floor_at(0, no_slip()), left_at(0, free_slip())},
                                  .body_force = {{0, 0}}};
  auto still = printed<PrescribedMotion>(pool, {.cell = 0.1, .spacing = 0.03, .time_step = 0.01});
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
  auto resting = printed<PrescribedMotion>(pool, {.cell = 0.05, .spacing = 0.025, .time_step = 5e-3});
  run(resting, 4000);
  const Samples end = resting.samples();
  const Scalars weight_above = 1000 * 0.02 * (0.5 - end.x.row(1).array()).transpose();  // Pa
  EXPECT_LT(end.v.colwise().norm().maxCoeff(), 1e-4);
  EXPECT_LT((end.pressure - weight_above).abs().maxCoeff(), 0.1 * weight_above.maxCoeff());
}

TEST(Mpm, KeepsAllParticlesOfADamBreakInTheTank) {
  auto breaking = printed<PrescribedMotion>(dam(), dam_settings);
  run(breaking, 600);
  const Samples end = breaking.samples();
  EXPECT_GT(end.x.row(0).maxCoeff(), 0.9);  // the front has reached the far wall
  EXPECT_GE(end.x.minCoeff(), 0);
  EXPECT_LE(end.x.row(0).maxCoeff(), 1);
}

TEST(Mpm, RunsTwiceToTheSameBits) {
  auto one = printed<PrescribedMotion>(dam(), dam_settings);
  auto other = printed<PrescribedMotion>(dam(), dam_settings);
  run(one, 400);
  run(other, 400);
  EXPECT_EQ(one.samples().x, other.samples().x);
  EXPECT_EQ(one.samples().v, other.samples().v);
  EXPECT_TRUE((one.samples().pressure == other.samples().pressure).all());
}

/// The same bits after some steps, for one thread and for more.
template <class Force, class FluidLaw>
void expect_same_bits(const Scene<FluidLaw, Force>& scene, Settings settings, int steps) {
  auto one = printed<PrescribedMotion>(scene, settings);
  run(one, steps);
  const Samples expected = one.samples();
  for (int threads : {2, 3}) {
    settings.threads = threads;
    auto shared = printed<PrescribedMotion>(scene, settings);
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
      auto falling = printed<PrescribedMotion>(drop(Uniform{{0, -10}}),
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
  auto in_a_tank = printed<PrescribedMotion>(dam(), dam_settings);
  auto in_a_lake = printed<PrescribedMotion>(wide, dam_settings);
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
  auto fine = printed<PrescribedMotion>(channel, settings);
  auto coarse = printed<PrescribedMotion, float>(channel, settings);
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
  auto breaking = printed<PrescribedMotion>(dam(), dam_settings);
  breaking.step(Heard{parts});
  EXPECT_EQ(parts,
            (std::vector<SubStep>{SubStep::scatter, SubStep::grid, SubStep::remap, SubStep::gather, SubStep::sorting}));
}

TEST(Mpm, CountsStepsAndTime) {
  auto breaking = printed<PrescribedMotion>(dam(), dam_settings);
  run(breaking, 3);
  EXPECT_EQ(breaking.steps(), 3);
  EXPECT_DOUBLE_EQ(breaking.time(), 3 * 4e-3);
  EXPECT_EQ(breaking.time_step(), 4e-3);
  EXPECT_TRUE(breaking.cell_size().isApprox(Vec2(0.1, 0.1)));
  EXPECT_EQ(breaking.samples().time, breaking.time());
}

TEST(Mpm, StopsWhenFluidLeavesTheDomain) {
  expect_stop_of_a_fall(
      printed<PrescribedMotion>(drop(Uniform{{0, -10}}), {.cell = 0.1, .spacing = 0.1, .time_step = 0.01}));
}

TEST(Mpm, DiagnosesANumberThatIsNotOneInTheStepItAppears) {
  // In one step number 99 spoils two cells on every side: (16), then (18).
  expect_stop_of_spoilt(printed<PrescribedMotion>(drop(spoilt()), {.cell = 0.1, .spacing = 0.1, .time_step = 0.01}), 77);
}

TEST(Mpm, DiagnosesACollapse) {
  auto squeezed =
      printed<PrescribedMotion>(drop(blow([](const Vec2& x) -> Vec2 { return -500 * (x - Vec2(0.5, 0.5)); })),
                               {.cell = 0.1, .spacing = 0.1, .time_step = 0.05});
  EXPECT_THROW(run(squeezed, 20), Diverged);
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Scene<Tait, Uniform> tank() {
  return {.domain = {.box = {.high = {1.61, 1.2}}},
          .fluid = {.density = 1000, .bulk_modulus = 0.36 * MPa},
          .filled = {.high = {0.6, 0.6}},
          .walls = {floor_at(0, free_slip()), right_at(1.61, free_slip())},
          .body_force = {{0, 0}}};
}
constexpr Settings coarse{.cell = 0.1, .spacing = 0.05, .time_step = 1e-4};

std::string refusal(const Scene<Tait, Uniform>& scene, const Settings& settings) {
  try {
    printed<PrescribedMotion>(scene, settings);
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "accepted";
}

TEST(Mpm, StartsAtRestWithTheMassOfItsFluid) {
  const auto dam = printed<PrescribedMotion>(tank(), coarse);
  const Samples s = dam.samples();
  EXPECT_EQ(dam.particles(), 144);
  EXPECT_EQ(dam.boundary_particles(), 0);
  EXPECT_DOUBLE_EQ(s.mass.sum(), 1000 * 0.36);
  EXPECT_DOUBLE_EQ(s.volumes().sum(), 0.36);
  EXPECT_EQ(s.v.norm(), 0);
  EXPECT_EQ(s.pressure.abs().maxCoeff(), 0);
  EXPECT_TRUE(s.x.isApprox(lattice({.high = {0.6, 0.6}}, 0.05).places(), 1e-14));
}

TEST(Mpm, RefusesCellsThatAreNotPositive) {
  for (double cell : {0.0, -0.1, nan, infinity, 1e-30}) {
    Settings wrong = coarse;
    wrong.cell = cell;
    EXPECT_NE(refusal(tank(), wrong).find("mpm: cell = "), std::string::npos) << refusal(tank(), wrong);
  }
}

TEST(Mpm, RefusesSpacingsThatAreNotPositiveOrLargerThanTheFluid) {
  for (double spacing : {0.0, -0.1, nan, infinity, 1e-30, 0.7}) {
    Settings wrong = coarse;
    wrong.spacing = spacing;
    EXPECT_NE(refusal(tank(), wrong).find("lattice: spacing"), std::string::npos) << refusal(tank(), wrong);
  }
}

TEST(Mpm, RefusesTimeStepsThatAreNotPositive) {
  for (double time_step : {0.0, -1e-4, nan, infinity}) {
    Settings wrong = coarse;
    wrong.time_step = time_step;
    EXPECT_NE(refusal(tank(), wrong).find("mpm: time step [s] = "), std::string::npos) << refusal(tank(), wrong);
  }
}

TEST(Mpm, RefusesToRunOnNoThreads) {
  for (int threads : {0, -1}) {
    Settings wrong = coarse;
    wrong.threads = threads;
    EXPECT_NE(refusal(tank(), wrong).find("mpm: threads = "), std::string::npos) << refusal(tank(), wrong);
  }
}

TEST(Mpm, RefusesFluidOutsideTheDomain) {
  for (double high : {1.7, nan}) {
    Scene<Tait, Uniform> scene = tank();
    scene.filled.high.x() = high;
    EXPECT_NE(refusal(scene, coarse).find("scene: filled box"), std::string::npos) << refusal(scene, coarse);
  }
}

TEST(Mpm, RefusesWallsOffTheGrid) {
  for (double y : {0.03, -0.1, 1.3, nan}) {
    Scene<Tait, Uniform> scene = tank();
    scene.walls = {floor_at(y, free_slip())};
    EXPECT_NE(refusal(scene, coarse).find("mpm: wall at y = "), std::string::npos) << refusal(scene, coarse);
  }
}

TEST(Mpm, RefusesWallsWhoseAnswerDependsOnTheDistanceThatItsNodesDoNotHave) {
  Scene<Tait, Uniform> scene = tank();
  scene.walls = {floor_at(0, navier_slip(0.1))};
  EXPECT_EQ(refusal(scene, coarse),
            "mpm: wall at y = 0 m answers by the distance of the fluid, expected one that can be asked on the wall");
}

TEST(Mpm, RefusesInOneLine) {
  Settings wrong = coarse;
  wrong.spacing = 0.7;
  EXPECT_EQ(refusal(tank(), wrong),
            "lattice: spacing = 0.7 m, expected at most the box of 0.6 m x 0.6 m, and at most 1e+09 particles");
}

/// The fast transfer against the plain loops over particles and their four nodes of plain MPM.
template <class FluidLaw>
void expect_equal_runs(const Scene<FluidLaw, ForceField>& scene, const Settings& settings, int steps) {
  auto fast = printed<PrescribedMotion>(scene, settings);
  auto plain = mpm::plain<LinearHat, Flip>(scene, settings);
  for (int step = 0; step < steps; ++step) {
    fast.step();
    plain.step();
  }
  const Samples end = fast.samples(), expected = plain.samples();
  const double fastest = end.v.colwise().norm().maxCoeff();
  ASSERT_GT(fastest * settings.time_step * steps, fast.cell_size().x());  // cells have been crossed
  for (int p = 0; p < end.size(); ++p) {
    EXPECT_LT((end.x.col(p) - expected.x.col(p)).norm(), 1e-9 * fast.cell_size().x()) << p;
    EXPECT_LT((end.v.col(p) - expected.v.col(p)).norm(), 1e-9 * fastest) << p;
    EXPECT_NEAR(end.density[p], expected.density[p], 1e-9 * scene.fluid.density) << p;
  }
}

TEST(Transfer, EqualsThePlainLoopForAViscousFluidAcrossThePeriodicBoundary) {
  constexpr double height = 0.46;     // five cells that are not square
  for (double length : {0.6, 0.8}) {  // with cells left over beside whole blocks, and without
    const Scene<Newtonian, ForceField> channel{
        .domain = {.box = {.high = {length, height}}, .periodic_x = true},
        .fluid = {{.density = 1000, .bulk_modulus = 143}, 20},
        .filled = {.high = {length, height}},
        .walls = {floor_at(0, no_slip()), ceiling_at(height, no_slip())},
        .body_force = stirring({length, height}, 2),
    };
    for (double spacing : {0.1, 0.05, 0.1 / 3, 0.025, 0.1 / 7})
      expect_equal_runs(channel, {.cell = 0.1, .spacing = spacing, .time_step = 5e-3}, 100);
  }
}

TEST(Transfer, EqualsThePlainLoopForAnInviscidFluidInACorner) {
  expect_equal_runs(heap(), {.cell = 0.1, .spacing = 0.03, .time_step = 2e-3}, 150);
}

template <class Number>
LanesOf<Number> counted_from(Number first) {
  LanesOf<Number> numbers;
  for (int lane = 0; lane < lanes_of<Number>; ++lane) numbers[lane] = first + static_cast<Number>(lane);
  return numbers;
}

TEST(Lanes, NoticeOneNumberThatIsNotOne) {
  for (int lane = 0; lane < lanes; ++lane) {
    Lanes a = fill<Lanes>(0.5);
    EXPECT_TRUE(all<Lanes>(between(0, a, 1)));
    for (const double limit : {0.0, 1.0}) {
      a[lane] = limit;
      EXPECT_TRUE(all<Lanes>(between(0, a, 1)));
    }
    a[lane] = std::nan("");
    EXPECT_FALSE(all<Lanes>(between(0, a, 1)));
    a[lane] = 1.001;
    EXPECT_FALSE(all<Lanes>(between(0, a, 1)));
  }
}

TEST(Lanes, HandTheLastOnTheLeftToTheFirst) {
  const Lanes numbers = shifted<1>(counted_from(1.0), counted_from(1.0 + lanes));
  for (int lane = 0; lane < lanes; ++lane) EXPECT_EQ(numbers[lane], lanes + lane);
}

TEST(Lanes, AreTheSameNumbersWidenedAndJoined) {
  const auto numbers = counted_from(1.0F);
  const Lanes first = widened<0>(numbers), second = widened<1>(numbers);
  const auto again = joined<LanesOf<float>>([&](int lane) { return lane == 0 ? first : second; });
  for (int lane = 0; lane < lanes; ++lane) {
    EXPECT_EQ(first[lane], 1 + lane);
    EXPECT_EQ(second[lane], 1 + lanes + lane);
  }
  for (int lane = 0; lane < lanes_of<float>; ++lane) EXPECT_EQ(again[lane], numbers[lane]);
}

}  // namespace
}  // namespace touchstone::mpm
