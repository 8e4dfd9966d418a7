#include "solvers/fluids/tait.hpp"
#include "solvers/mpm/printed/mpm.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/navier_slip.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::mpm {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Scene<Tait> tank() {
  return {.domain = {.box = {.high = {1.61, 1.2}}},
          .fluid = {.density = 1000, .bulk_modulus = 0.36 * MPa},
          .filled = {.high = {0.6, 0.6}},
          .walls = {floor_at(0, free_slip()), right_at(1.61, free_slip())}};
}
constexpr Settings coarse{.cell = 0.1, .spacing = 0.05, .time_step = 1e-4};

std::string refusal(const Scene<Tait>& scene, const Settings& settings) {
  try {
    solver<PrescribedMotion>(scene, settings);
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "accepted";
}

TEST(Grid, FillsItsBoxWithWholeCells) {
  const Grid grid({.box = {.high = {1.61, 1.2}}}, 0.1);
  EXPECT_EQ(grid.columns, 16);
  EXPECT_EQ(grid.rows, 12);
  EXPECT_DOUBLE_EQ(grid.columns * grid.cell.x(), 1.61);
  EXPECT_EQ(grid.nodes(), 17 * 13);
}

TEST(Grid, ClosesThePeriodicBoundary) {
  const Grid grid({.box = {.high = {0.4, 0.3}}, .periodic_x = true}, 0.1);
  EXPECT_EQ(grid.nodes(), 4 * 4);
  for (int row = 0; row < grid.rows; ++row) {
    EXPECT_EQ(grid.corners(grid.cell_at(3, row))[1], grid.corners(grid.cell_at(0, row))[0]);
    EXPECT_EQ(grid.corners(grid.cell_at(3, row))[3], grid.corners(grid.cell_at(0, row))[2]);
  }
}

TEST(Grid, FindsTheNodesOfWalls) {
  const Grid grid({.box = {.low = {-1, 2}, .high = {1, 3}}}, 0.5);
  EXPECT_EQ(grid.nodes_on(floor_at(2, free_slip())), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(grid.nodes_on(right_at(1, free_slip())), (std::vector<int>{4, 9, 14}));
}

TEST(Lattice, FillsItsBoxEvenly) {
  const Box filled{.low = {1, 2}, .high = {1.61, 2.4}};
  const Lattice points = lattice(filled, 0.1);
  EXPECT_EQ(points.places().cols(), 6 * 4);
  EXPECT_DOUBLE_EQ(points.volume() * 24, 0.61 * 0.4);
  EXPECT_NEAR(points.places().row(0).mean(), 1.305, 1e-12);
  EXPECT_NEAR(points.places().col(0).y() - 2, 0.05, 1e-12);
  EXPECT_NEAR(points.places().col(1).x() - points.places().col(0).x(), 0.61 / 6, 1e-12);
}

TEST(Mpm, StartsAtRestWithTheMassOfItsFluid) {
  const auto dam = solver<PrescribedMotion>(tank(), coarse);
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
    Scene<Tait> scene = tank();
    scene.filled.high.x() = high;
    EXPECT_NE(refusal(scene, coarse).find("scene: filled box"), std::string::npos) << refusal(scene, coarse);
  }
}

TEST(Mpm, RefusesWallsOffTheGrid) {
  for (double y : {0.03, -0.1, 1.3, nan}) {
    Scene<Tait> scene = tank();
    scene.walls = {floor_at(y, free_slip())};
    EXPECT_NE(refusal(scene, coarse).find("mpm: wall at y = "), std::string::npos) << refusal(scene, coarse);
  }
}

TEST(Mpm, RefusesWallsWhoseAnswerDependsOnTheDistanceThatItsNodesDoNotHave) {
  Scene<Tait> scene = tank();
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

}  // namespace
}  // namespace touchstone::mpm
