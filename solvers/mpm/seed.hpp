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

/// Particles at rest where a scene puts them, in the order of their cells. Throws std::invalid_argument for a spacing
/// larger than the filled box, or water outside the domain.
template <class Particles, class AnyScene>
Particles at_rest(const AnyScene& scene, double spacing, const Grid& grid) {
  const Lattice points = lattice(scene.filled, spacing, scene.domain.box);
  const Vectors places = places_in(scene.domain.box, scene.start, points);
  const std::vector<int> cells = cells_of(places, grid);
  Particles particles(places.cols(), scene.fluid.density * points.volume(), {grid.columns, grid.rows, cells});
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
