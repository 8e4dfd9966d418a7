#pragma once
#include "solvers/mpm/cell_lanes.hpp"
#include "solvers/mpm/cell_order.hpp"

namespace touchstone::mpm {

/// What a density may be, in densities at rest, before a run counts as diverged: far beyond what Tait's law is for.
inline constexpr double least_density = 0.2, most_density = 5;

/// What the particles of all methods in cells have, component by component, in the order of their cells.
///
/// A place is kept within its cell, which the order knows, so that a wrap across a periodic boundary loses no digit.
/// All particles of a scene have the same mass; it cancels from (10) to (17) and is left out of them. A slot without a
/// particle holds a particle at rest in the corner of its cell: but for its mass it adds nothing to any sum.
template <class Number_>
struct ParticlesInCells {
  using Number = Number_;
  static constexpr int width = lanes_of<Number>;  // cells in a block

  Eigen::Index count;
  double mass;              // kg/m   of each
  Field<Number> X, Y;       // -      place within the cell, 0 to 1
  Field<Number> expansion;  // -      rho0 / rho - 1
  Field<int> number;        // as seeded; the same at all times
  CellOrder<width> order;

  /// At rest, with places and numbers yet to be written.
  ParticlesInCells(Eigen::Index n, double mass_of_each, CellOrder<width> cells)
      : count(n),
        mass(mass_of_each),
        X(cells.slots()),
        Y(X),
        expansion(X),
        number(cells.slots()),
        order(std::move(cells)) {}
};

}  // namespace touchstone::mpm
