#pragma once
#include "solvers/lattice.hpp"
#include "solvers/mpm/grid.hpp"

#include <algorithm>
#include <vector>

namespace touchstone::mpm {

/// The cell of each place in the box of the grid.
inline std::vector<int> cells_of(const Vectors& places, const Grid& grid) {
  std::vector<int> cells;
  for (const auto& x : places.colwise()) {
    const Eigen::Array2d along = (x - grid.box.low).array() / grid.cell.array();
    cells.push_back(grid.cell_at(std::clamp(static_cast<int>(along.x()), 0, grid.columns - 1),
                                 std::clamp(static_cast<int>(along.y()), 0, grid.rows - 1)));
  }
  return cells;
}

/// Particles at rest at the points of a lattice, in the order of their cells.
template <class Particles, class FluidLaw>
Particles at_rest(const Lattice& points, const Grid& grid, const FluidLaw& fluid) {
  const Vectors places = points.places();
  const std::vector<int> cells = cells_of(places, grid);
  Particles particles(places.cols(), fluid.density * points.volume(), {grid.columns, grid.rows, cells});
  std::vector<int> taken(grid.cells(), 0);
  for (int p = 0; p < particles.count; ++p) {
    const int slot = particles.order.slot(cells[p], taken[cells[p]]++);
    const Eigen::Array2d within = (places.col(p) - grid.place(cells[p], 0, 0)).array() / grid.cell.array();
    particles.X[slot] = static_cast<typename Particles::Number>(within.x());
    particles.Y[slot] = static_cast<typename Particles::Number>(within.y());
    particles.number[slot] = p;
  }
  return particles;
}

}  // namespace touchstone::mpm
