#pragma once
#include "solvers/mpm/nodes.hpp"
#include "solvers/mpm/particles.hpp"

#include <algorithm>

namespace touchstone::mpm {

/// Particles to begin with.
struct Lattice {
  Vectors x;      // m   numbered along x, then along y
  double volume;  // m²  of each
};

/// The centres of a square lattice, stretched by at most half a spacing in all so as to fill the box exactly.
/// Throws std::invalid_argument for a spacing [m] that is not positive or larger than the box, and for a box that
/// reaches out of the domain.
inline Lattice lattice(const Box& filled, double spacing, const Box& domain) {
  if (!(domain.contains(filled.low) && domain.contains(filled.high)))
    throw std::invalid_argument(fmt::format(
        "mpm: filled box ({:g}, {:g}) to ({:g}, {:g}) m, wanted inside the domain ({:g}, {:g}) to ({:g}, {:g}) m",
        filled.low.x(), filled.low.y(), filled.high.x(), filled.high.y(), domain.low.x(), domain.low.y(),
        domain.high.x(), domain.high.y()));
  constexpr double most = 1e9;  // so that particles can be counted in an int
  const Eigen::Array2d size = filled.size();
  const Eigen::Array2d counts = (size / spacing).round();
  if (!(spacing > 0 && (spacing <= size * (1 + 1e-9)).all() && counts.prod() <= most))  // but for rounding
    throw std::invalid_argument(fmt::format(
        "mpm: spacing = {:g} m, wanted positive, at most the filled {:g} m x {:g} m, and at most {:g} particles",
        spacing, size.x(), size.y(), most));
  const auto nx = static_cast<Eigen::Index>(counts.x()), ny = static_cast<Eigen::Index>(counts.y());
  Lattice points{.x = Vectors(2, nx * ny), .volume = size.prod() / counts.prod()};
  for (Eigen::Index p = 0; p < nx * ny; ++p) {
    const Eigen::Array2d centre(static_cast<double>(p % nx) + 0.5, static_cast<double>(p / nx) + 0.5);
    points.x.col(p) = filled.low.array() + centre / counts * size;
  }
  return points;
}

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
template <class FluidLaw>
Particles<FluidLaw> at_rest(const Lattice& points, const Grid& grid, const FluidLaw& fluid) {
  const std::vector<int> cells = cells_of(points.x, grid);
  Particles<FluidLaw> particles(points.x.cols(), fluid.density * points.volume, fluid.density,
                                CellOrder(grid.cells(), cells));
  std::vector<int> taken(grid.cells(), 0);
  for (int p = 0; p < particles.count; ++p) {
    const int slot = particles.order.begin(cells[p]) + taken[cells[p]]++;
    const Eigen::Array2d within = (points.x.col(p) - grid.place(cells[p], 0, 0)).array() / grid.cell.array();
    particles.X[slot] = within.x();
    particles.Y[slot] = within.y();
    particles.number[slot] = p;
  }
  return particles;
}

}  // namespace touchstone::mpm
