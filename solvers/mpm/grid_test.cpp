#include "solvers/mpm/sorting.hpp"

#include "solvers/fluids/newtonian.hpp"
#include "solvers/mpm/beginning.hpp"
#include "solvers/mpm/printed/particles.hpp"
#include "solvers/walls/free_slip.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::mpm {
namespace {

constexpr Tait water{.density = 1000, .bulk_modulus = 143};
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

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
    EXPECT_EQ(grid.node_at(4, row), grid.node_at(0, row));
    EXPECT_EQ(grid.node_at(4, row + 1), grid.node_at(0, row + 1));
  }
}

TEST(Grid, FindsTheNodesOfWalls) {
  const Grid grid({.box = {.low = {-1, 2}, .high = {1, 3}}}, 0.5);
  EXPECT_EQ(grid.nodes_on(floor_at(2, free_slip())), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(grid.nodes_on(right_at(1, free_slip())), (std::vector<int>{4, 9, 14}));
}

TEST(Grid, HasCellsAroundItsNodes) {
  const Grid around = Grid({.box = {.high = {0.4, 0.3}}, .periodic_x = true}, 0.1).around_nodes();
  EXPECT_EQ(around.columns, 4);
  EXPECT_EQ(around.rows, 4);
  EXPECT_TRUE(around.place(around.cell_at(1, 3), 0.5, 0.5).isApprox(Vec2(0.1, 0.3)));
}

TEST(Beginning, HasTheSlopesOfALinearVelocityAlsoOnAnEdge) {
  const Grid grid({.box = {.high = {1, 2}}}, 0.1);
  const Start start{.velocity = [](const Vec2& x) -> Vec2 {
    return {1 + 2 * x.x() - 3 * x.y(), 4 * x.x() + 5 * x.y()};
  }};
  for (const Vec2& x : {Vec2(0.5, 0.5), Vec2(0, 0.7), Vec2(1, 2), Vec2(0.3, 2), Vec2(1e-5, 1e-5)}) {
    const Beginning found = beginning_at(x, start, grid, Newtonian{{.density = 1000, .bulk_modulus = 1000}, 1});
    EXPECT_NEAR(found.of.xx, 2, 1e-9) << x.transpose();
    EXPECT_NEAR(found.of.xy, -3, 1e-9) << x.transpose();
    EXPECT_NEAR(found.of.yx, 4, 1e-9) << x.transpose();
    EXPECT_NEAR(found.of.yy, 5, 1e-9) << x.transpose();
  }
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

TEST(Lattice, HasNoMoreParticlesThanAnIntCounts) {
  EXPECT_EQ(lattice({.high = {1e9, 1}}, 1).columns, 1000000000);
  EXPECT_THROW(lattice({.high = {1e9 + 1, 1}}, 1), std::invalid_argument);
}

TEST(Scenes, MayFillADomainThatBeginsAnywhere) {
  const Box box{.low = {-1, 2}, .high = {1, 3}};
  EXPECT_NO_THROW(require_filled("method", box, box));
  EXPECT_THROW(require_filled("method", {.low = {-1, 2.1}, .high = {1, 3}}, box), std::invalid_argument);
  EXPECT_THROW(require_filled("method", {.low = {-1, 2}, .high = {0.9, 3}}, box), std::invalid_argument);
}

TEST(Scenes, NameTheParticleThatStartsOutsideTheDomain) {
  const Box box{.high = {1, 1}};
  const Start start{.places = [](const Vectors&) { return Vectors{{0.5, 2}, {0.5, 3}}; }};
  try {
    places_in(box, start, lattice(box, 0.5));
    FAIL() << "started";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "scene: particle 1 starts at (2, 3) m, expected inside the domain (0, 0) to (1, 1) m");
  }
}

/// A box of 4 x 3 cells of 0.1 m with one particle in the middle of each.
struct Pool {
  Grid grid;
  PrintedParticles<Tait> particles;

  explicit Pool(bool periodic_x)
      : grid({.box = {.high = {0.4, 0.3}}, .periodic_x = periodic_x}, 0.1),
        particles(at_rest<PrintedParticles<Tait>>(Scene<Tait>{.domain = {.box = grid.box}, .fluid = water, .filled = grid.box},
                                           0.1, grid)) {}

  int slot(int cell) const { return particles.order.slot(cell, 0); }
  double& X(int cell) { return particles.X[slot(cell)]; }
  double& Y(int cell) { return particles.Y[slot(cell)]; }
  int settled(int cell) { return settle(particles, slot(cell), cell, grid, water, 17, 0.5); }
  Diverged::Fault fault(int cell) {
    try {
      settled(cell);
    } catch (const Diverged& diverged) {
      return diverged.fault;
    }
    return {};
  }
};

TEST(Settle, LeavesAParticleInItsCell) {
  Pool pool(false);
  EXPECT_EQ(pool.settled(6), 6);
  EXPECT_DOUBLE_EQ(pool.X(6), 0.5);
}

TEST(Settle, MovesAParticleToTheCellItIsIn) {
  Pool pool(false);
  const Vec2 place = pool.grid.place(5, 1.25, -0.5);
  pool.X(5) = 1.25;
  pool.Y(5) = -0.5;
  const int to = pool.settled(5);
  EXPECT_EQ(to, pool.grid.cell_at(2, 0));
  EXPECT_TRUE(pool.grid.place(to, pool.X(5), pool.Y(5)).isApprox(place));
}

TEST(Settle, WrapsAcrossThePeriodicBoundaryWithoutLosingADigit) {
  Pool pool(true);
  pool.X(7) = 1.25;
  EXPECT_EQ(pool.settled(7), 4);
  EXPECT_EQ(pool.X(7), 0.25);
  pool.X(8) = -0.25;
  EXPECT_EQ(pool.settled(8), 11);
  EXPECT_EQ(pool.X(8), 0.75);
}

TEST(Settle, KeepsAParticleThatIsPastTheEndByRounding) {
  Pool pool(false);
  pool.X(7) = 1 + 1e-15;
  pool.Y(3) = -1e-16;
  EXPECT_EQ(pool.settled(7), 7);
  EXPECT_EQ(pool.X(7), 1);
  EXPECT_EQ(pool.settled(3), 3);
  EXPECT_EQ(pool.Y(3), 0);
  pool.X(11) = 1 + 1e-12;
  EXPECT_THROW(pool.settled(11), Diverged);
}

TEST(Settle, ReportsAParticleThatLeftTheDomain) {
  Pool pool(false);
  pool.particles.number[pool.slot(7)] = 42;
  pool.X(7) = 1.5;
  const Diverged::Fault fault = pool.fault(7);
  EXPECT_EQ(fault.step, 17);
  EXPECT_EQ(fault.time, 0.5);
  EXPECT_EQ(fault.particle, 42);
  EXPECT_EQ(fault.quantity, "x [m]");
  EXPECT_DOUBLE_EQ(fault.value, 0.45);
  EXPECT_EQ(fault.expected, "0 to 0.4");
  EXPECT_DOUBLE_EQ(fault.place.y(), 0.15);
}

TEST(Settle, ReportsAPlaceThatIsNotANumberOrFarAway) {
  for (double lost : {nan, 1e300, -1e300, std::numeric_limits<double>::infinity()})
    for (bool periodic : {true, false}) {
      Pool pool(periodic);
      pool.Y(3) = lost;
      EXPECT_EQ(pool.fault(3).quantity, "y [m]");
      EXPECT_EQ(pool.fault(3).particle, 3);
      pool.X(3) = lost;
      EXPECT_EQ(pool.fault(3).quantity, "x [m]");
    }
}

TEST(Settle, ReportsAnImplausibleDensity) {
  for (double density : {nan, 199.0, 5001.0, -1000.0}) {
    Pool pool(true);
    pool.particles.expansion[pool.slot(2)] = 1000 / density - 1;
    EXPECT_EQ(pool.fault(2).quantity, "density [kg/m³]") << density;
    EXPECT_EQ(pool.fault(2).expected, "200 to 5000");
  }
}

}  // namespace
}  // namespace touchstone::mpm
