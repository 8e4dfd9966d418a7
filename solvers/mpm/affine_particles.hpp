#pragma once
#include "solvers/lattice.hpp"
#include "solvers/mpm/seed.hpp"

namespace touchstone::mpm {

/// The state of all particles of the affine method, component by component, in the order of their cells; places and the
/// spare slot as in `Particles`.
///
/// What a particle gives to a node is its velocity and four times the lever of the node times `along_x` and `along_y`:
/// a quarter of what the affine velocity C gains over a cell, less what the stress takes from it in a step,
/// (C - 4 dt / cell² stress / density) cell / 4. Neither C nor the stress is needed by itself.
struct AffineParticles {
  struct Component {
    Scalars v;                 // m/s
    Scalars along_x, along_y;  // m/s  per cell, over four

    explicit Component(Eigen::Index slots)
        : v(Scalars::Zero(slots)), along_x(Scalars::Zero(slots)), along_y(Scalars::Zero(slots)) {}
  };

  Eigen::Index count;
  double mass;              // kg/m   of each
  Scalars X, Y;             // -      place within the cell, 0 to 1
  Component x, y;           // of the velocity
  Scalars specific_volume;  // m³/kg  1 / rho
  Eigen::ArrayXi number;    // as seeded; the same at all times
  CellOrder order;

  /// At rest, with places and numbers yet to be written.
  AffineParticles(Eigen::Index n, double mass_of_each, double density, CellOrder cells)
      : count(n),
        mass(mass_of_each),
        X(Scalars::Zero(n + 1)),
        Y(Scalars::Zero(n + 1)),
        x(n + 1),
        y(n + 1),
        specific_volume(Scalars::Constant(n + 1, 1 / density)),
        number(n + 1),
        order(std::move(cells)) {}

  int spare() const { return static_cast<int>(count); }

  void copy(int from, int to) {
    for (Scalars* field : {&X, &Y, &x.v, &x.along_x, &x.along_y, &y.v, &y.along_x, &y.along_y, &specific_volume})
      (*field)[to] = (*field)[from];
    number[to] = number[from];
  }
};

/// Particles at rest at the points of a lattice, in the order of their cells.
template <class FluidLaw>
AffineParticles affine_at_rest(const Lattice& points, const Grid& grid, const FluidLaw& fluid) {
  const Vectors places = points.places();
  const std::vector<int> cells = cells_of(places, grid);
  AffineParticles particles(places.cols(), fluid.density * points.volume(), fluid.density,
                            CellOrder(grid.cells(), cells));
  std::vector<int> taken(grid.cells(), 0);
  for (int p = 0; p < particles.count; ++p) {
    const int slot = particles.order.begin(cells[p]) + taken[cells[p]]++;
    const Eigen::Array2d within = (places.col(p) - grid.place(cells[p], 0, 0)).array() / grid.cell.array();
    particles.X[slot] = within.x();
    particles.Y[slot] = within.y();
    particles.number[slot] = p;
  }
  return particles;
}

}  // namespace touchstone::mpm
