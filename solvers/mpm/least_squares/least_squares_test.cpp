#include "solvers/mpm/least_squares/least_squares.hpp"

#include "solvers/forces/uniform.hpp"
#include "solvers/testing.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"

namespace touchstone::mpm {
namespace {

constexpr Settings coarse{.cell = 0.1, .spacing = 0.05, .time_step = 1e-3};

struct LeastSquaresMethod {
  static auto solver(const auto& scene, const Settings& settings = coarse) {
    return least_squares(as_one_kind(scene), settings);
  }
};

Scene<Newtonian, Uniform> between_plates(const WallVelocity& low, const WallVelocity& high, const Start& start,
                                         const Vec2& force = Vec2::Zero()) {
  return {.domain = {.box = {.high = {1, 1}}, .periodic_x = true},
          .fluid = oil,
          .filled = {.high = {1, 1}},
          .walls = {floor_at(0, low), ceiling_at(1, high)},
          .body_force = {force},
          .start = start};
}

double field(double x, double y) { return 3 - x + 2 * y + 4 * x * x - x * y + 0.5 * y * y; }

TEST(FittedNodes, KnowAFieldOfSecondDegreeAtNodesAndAtParticlesAnywhere) {
  const Grid grid({.box = {.high = {1, 1}}}, 0.1), cells = grid.around_nodes();
  Vectors places = lattice({.high = {1, 1}}, 0.05).places();
  places.row(0).array() += 0.06 * (37 * places.row(1).array()).sin();  // some of them outside
  places.row(1).array() += 0.06 * (53 * places.row(0).array()).cos();
  FittedParticles all;
  all.lay_out(places, cells);
  all.order.for_each([&](int cell, int slot) {
    all.X[slot] = 10 * all.x[slot] - cell % cells.columns;
    all.Y[slot] = 10 * all.y[slot] - cell / cells.columns;
    all.vx[slot] = field(all.x[slot], all.y[slot]);
    all.vy[slot] = -all.vx[slot];
    all.rho[slot] = 1000 + all.vx[slot];
  });
  FittedNodes nodes(cells, 1);
  nodes.fit_to(all, 1000);
  for (int row = 0; row < cells.rows; ++row)
    for (int column = 0; column < cells.columns; ++column) {
      const double exact = field(0.1 * column, 0.1 * row);
      EXPECT_NEAR(nodes.velocity(nodes.node_at(column, row)).x(), exact, 1e-9);
      EXPECT_NEAR(nodes.velocity(nodes.node_at(column, row)).y(), -exact, 1e-9);
      EXPECT_NEAR(nodes.fit[FittedNodes::excess][0][nodes.node_at(column, row)], exact, 1e-9);
    }
  const auto parabola = [](double first, double second, double third) { return 3 * (first - second) + third; };
  Field<double> values = nodes.fit[FittedNodes::v_x][0];
  nodes.extend(values, parabola);
  for_blocks(all, nodes, 1, [&](Index, const auto& block, int node) {
    for_particles_of(block, [&](int slot, const auto& write) {
      const Monomials X = all.place(0, slot), Y = all.place(1, slot);
      const HatsAlong x = nodes.hats_at(0, block.column, X.X), y = nodes.hats_at(1, block.row, Y.X);
      const Lanes by_fits = joined(nodes.around(node)[FittedNodes::v_x], x, y),
                  by_values = value_at(nodes.parabolas(values, node), X, Y);
      for (int lane = 0; lane < lanes; ++lane)
        if (write.present[lane]) {
          EXPECT_NEAR(by_fits[lane], all.vx[slot + lane], 1e-9);
          EXPECT_NEAR(by_values[lane], all.vx[slot + lane], 1e-9);
        }
    });
  });
}

TEST(LeastSquaresMpm, ARunHasTheVelocityAndThePressureOfItsScene) {
  expect_as_in(varied_start(), after<LeastSquaresMethod>(0, endless(varied_start())), 1e-14, 1e-8);
}

TEST(LeastSquaresMpm, UniformFlowCrossesBothPeriodicBoundariesUnchanged) {
  const Vec2 v(7, -5), size(0.7, 0.9);
  const Scene<Newtonian> scene = endless(uniform_flow(v), size);
  expect_carried(after<LeastSquaresMethod>(0, scene), after<LeastSquaresMethod>(1000, scene), v, 1, size);
}

TEST(LeastSquaresMpm, AShearWaveDecaysAsItShouldAlongBothAxes) {
  const double exact = std::exp(-oil.kinematic_viscosity() * 4 * std::numbers::pi * std::numbers::pi);
  for (const int axis : {0, 1}) {
    const double left = amplitude_of_wave(after<LeastSquaresMethod>(1000, endless(shear_wave(axis, 0.1))), axis) / 0.1;
    EXPECT_NEAR(left, exact, 0.03 * exact) << axis;
  }
}

TEST(LeastSquaresMpm, AWaveOfSoundDecaysByFourThirdsOfTheViscosityAlongBothAxes) {
  for (const int axis : {0, 1}) {
    const double left = amplitude_of_sound(after<LeastSquaresMethod>(1000, endless(sound_wave(axis, 0.01)))) / 0.01;
    EXPECT_NEAR(left, sound_left_after(1), 0.02 * sound_left_after(1)) << axis;
  }
}

TEST(LeastSquaresMpm, SoundAndShearDecayAsTheyShouldInCellsThatAreNotSquare) {
  constexpr Settings oblong{.cell = 0.1, .spacing = 0.045, .time_step = 1e-3};
  for (const int axis : {0, 1}) {
    Vec2 size = Vec2::Constant(0.86);  // nine cells across, ten along
    size[axis] = 1;
    const double sound =
        amplitude_of_sound(after<LeastSquaresMethod>(1000, endless(sound_wave(axis, 0.01), size), oblong)) / 0.01;
    EXPECT_NEAR(sound, sound_left_after(1), 0.02 * sound_left_after(1)) << axis;
    const double exact = std::exp(-oil.kinematic_viscosity() * 4 * std::numbers::pi * std::numbers::pi),
                 shear = amplitude_of_wave(
                             after<LeastSquaresMethod>(1000, endless(shear_wave(axis, 0.1), size), oblong), axis) /
                         0.1;
    EXPECT_NEAR(shear, exact, 0.03 * exact) << axis;
  }
}

TEST(LeastSquaresMpm, ALinearProfileBetweenSlidingPlatesStaysToTheLastDigitsThroughRemeshing) {
  const Start linear{.velocity = [](const Vec2& x) -> Vec2 { return {2 * x.y() - 1, 0}; }};
  const Samples s = after<LeastSquaresMethod>(1000, between_plates(no_slip({-1, 0}), no_slip({1, 0}), linear));
  EXPECT_LT((s.v.row(0).array() - (2 * s.x.row(1).array() - 1)).abs().maxCoeff(), 1e-9);
  EXPECT_LT(s.v.row(1).array().abs().maxCoeff(), 1e-9);
}

TEST(LeastSquaresMpm, TheSteadyProfileOfAChannelIsExact) {
  const double force = 8 * oil.kinematic_viscosity();  // 1 m/s in the middle
  const Start parabola{.velocity = [](const Vec2& x) -> Vec2 { return {4 * x.y() * (1 - x.y()), 0}; }};
  const Samples s = after<LeastSquaresMethod>(1000, between_plates(no_slip(), no_slip(), parabola, {force, 0}));
  EXPECT_LT((s.v.row(0).array() - 4 * s.x.row(1).array() * (1 - s.x.row(1).array())).abs().maxCoeff(), 1e-9);
}

TEST(LeastSquaresMpm, FluidBesideAWallThatStartsToMoveFeelsItAtOnce) {
  const Samples s = after<LeastSquaresMethod>(0, between_plates(no_slip(), no_slip({1, 0}), {}));
  EXPECT_GT(s.v.row(0).maxCoeff(), 0.5);
  EXPECT_EQ(s.v.row(0).head(s.size() / 2).cwiseAbs().maxCoeff(), 0);
}

TEST(LeastSquaresMpm, FluidInACornerFeelsTheJumpOfBothItsWalls) {
  auto box = between_plates(no_slip(), no_slip(), uniform_flow({3, -2}));
  box.domain.periodic_x = false;
  box.walls.push_back(left_at(0, no_slip()));
  box.walls.push_back(right_at(1, no_slip()));
  const Samples s = after<LeastSquaresMethod>(0, box);
  const auto speed_at = [&](double x, double y) {
    Eigen::Index nearest;
    (s.x.colwise() - Vec2(x, y)).colwise().norm().minCoeff(&nearest);
    return s.v.col(nearest).norm();
  };
  for (const double x : {0.025, 0.975})
    for (const double y : {0.025, 0.975}) {
      EXPECT_LT(speed_at(x, y), 0.9 * speed_at(x, 0.475)) << x << ' ' << y;
      EXPECT_LT(speed_at(x, y), 0.9 * speed_at(0.475, y)) << x << ' ' << y;
    }
}

TEST(LeastSquaresMpm, FluidSlidesFreelyAlongASlipperyWall) {
  const Samples s = after<LeastSquaresMethod>(500, between_plates(free_slip(), free_slip(), uniform_flow({3, 0})));
  EXPECT_LT((s.v.row(0).array() - 3).abs().maxCoeff(), 1e-9);
}

TEST(LeastSquaresMpm, AShearWaveBetweenSlipperyWallsDecaysAsInEndlessFluid) {
  const auto wave = [](double y) { return std::cos(2 * std::numbers::pi * y); };
  const Start start{.velocity = [=](const Vec2& x) -> Vec2 { return {0.1 * wave(x.y()), 0}; }};
  const Samples s = after<LeastSquaresMethod>(1000, between_plates(free_slip(), free_slip(), start));
  double left = 0;
  for (Eigen::Index p = 0; p < s.size(); ++p) left += 20 * s.v(0, p) * wave(s.x(1, p)) / static_cast<double>(s.size());
  const double exact = std::exp(-oil.kinematic_viscosity() * 4 * std::numbers::pi * std::numbers::pi);
  EXPECT_NEAR(left, exact, 0.03 * exact);
}

TEST(LeastSquaresMpm, ALidDrivesTheFluidInAClosedBoxAndNoneLeaves) {
  expect_driven_by_the_lid(after<LeastSquaresMethod>(2000, under_a_lid()));
}

TEST(LeastSquaresMpm, ALidDrivesAlikeWhicheverWallItIs) {
  expect_a_quarter_turn_on(after<LeastSquaresMethod>(100, under_a_lid()),
                           after<LeastSquaresMethod>(100, beside_a_lid()), 20, 1e-9);
}

TEST(LeastSquaresMpm, TheMeanDensityOfAClosedBoxStaysWhatItWas) {
  const Samples s = after<LeastSquaresMethod>(500, under_a_lid());
  EXPECT_NEAR(s.density.mean(), oil.density, 1e-12 * oil.density);
  EXPECT_GT((s.density - oil.density).abs().maxCoeff(), 1e-4 * oil.density);  // though it changes from place to place
}

TEST(LeastSquaresMpm, ThreadsDoNotChangeABit) {
  const Start start{.velocity = [](const Vec2& x) -> Vec2 { return {std::sin(7 * x.y()), std::cos(5 * x.x())}; }};
  Settings settings = coarse;
  const Samples one = after<LeastSquaresMethod>(100, endless(start), settings);
  settings.threads = 3;
  const Samples three = after<LeastSquaresMethod>(100, endless(start), settings);
  EXPECT_EQ(one.x, three.x);
  EXPECT_EQ(one.v, three.v);
  EXPECT_EQ(one.pressure.matrix(), three.pressure.matrix());
}

TEST(LeastSquaresMpm, NamesTheAxisAlongWhichAParticleLeft) {
  for (const auto& [velocity, axis] : {std::pair(Vec2(1e4, 0), "x [m]"), std::pair(Vec2(0, 1e4), "y [m]")}) {
    auto scene = under_a_lid();
    scene.start = uniform_flow(velocity);
    auto blown_out = LeastSquaresMethod::solver(scene);
    try {
      for (int step = 0; step < 10; ++step) blown_out.step();
      ADD_FAILURE() << axis << ": nothing left";
    } catch (const Diverged& diverged) {
      EXPECT_EQ(diverged.fault.quantity, axis);
    }
  }
}

TEST(LeastSquaresMpm, RefusesTooFewParticlesInACellAndWaterThatDoesNotFillTheDomain) {
  EXPECT_THROW(LeastSquaresMethod::solver(endless({}), {.cell = 0.1, .spacing = 0.1, .time_step = 1e-3}),
               std::invalid_argument);
  Scene<Newtonian> scene = endless({});
  scene.filled.high.y() = 0.5;
  EXPECT_THROW(LeastSquaresMethod::solver(scene), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::mpm
