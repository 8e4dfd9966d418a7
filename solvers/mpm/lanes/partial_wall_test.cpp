#include "solvers/mpm/lanes/grid_walls.hpp"
#include "solvers/mpm/shapes/b_spline.hpp"
#include "solvers/walls/free_slip.hpp"

#include <gtest/gtest.h>

namespace touchstone::mpm {
namespace {

TEST(PartialWalls, HoldFluidBetweenBothTheirEndsAndNoneBeyond) {
  const Grid grid({.box = {.high = {1, 0.9}}}, 0.1);
  using Nodes = LaneNodes<ShapeInLanes<BSpline<2>>>;
  for (const int axis : {0, 1}) {
    Wall gate = axis == 0 ? right_at(0.45, free_slip()) : ceiling_at(0.45, free_slip());
    gate.extent = [](double time) -> Range { return {0.1 + time, 0.5 + time}; };
    Nodes nodes(grid, lanes);
    NodeVectors velocity(nodes.places());
    for (int node = 0; node < nodes.places(); ++node) {
      nodes.per_mass[node] = 1;
      velocity.set(node, {2, 2});
    }
    PartialSplineWall(gate, grid, nodes).hold(nodes, 0.1, velocity);
    for (int k = 1; k <= (axis == 0 ? grid.rows : grid.columns);
         ++k) {  // nodes in the middle of cells, and one outside
      const double place = 0.1 * (k - 0.5);
      const int at = axis == 0 ? 5 + k * nodes.stride : k + 5 * nodes.stride;  // in the middle of the cell of the gate
      const bool is_held = place > 0.2 && place < 0.6;
      EXPECT_NEAR(velocity[at][axis], is_held ? 2 - 2 * 0.75 / (0.75 * 0.75 + 2 * 0.125 * 0.125) : 2, 1e-12)
          << axis << ' ' << place;
      EXPECT_EQ(velocity[at][1 - axis], 2) << "it slips";
    }
  }
}

}  // namespace
}  // namespace touchstone::mpm
