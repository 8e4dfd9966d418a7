#pragma once
#include "solvers/mpm/cell_order.hpp"
#include "solvers/mpm/stress.hpp"

namespace touchstone::mpm {

/// What a density may be, in densities at rest, before a run counts as diverged: far beyond what Tait's law is for.
inline constexpr double least_density = 0.2, most_density = 5;

/// The state of all particles, component by component, in the order of their cells.
///
/// A place is kept within its cell, which the order knows, so that a wrap across the seam loses no digit. All particles
/// of a scene have the same mass; it cancels from (10) to (17) and is left out of them. One slot more than there are
/// particles is spare, for a particle on its way from cell to cell.
template <class FluidLaw>
struct Particles {
  Eigen::Index count;
  double mass;              // kg/m   of each
  Scalars X, Y;             // -      place within the cell, 0 to 1
  Scalars vx, vy;           // m/s
  Scalars specific_volume;  // m³/kg  1 / rho
  Stress<FluidLaw> stress;
  Eigen::ArrayXi number;  // as seeded; the same at all times
  CellOrder order;

  /// At rest, with places and numbers yet to be written.
  Particles(Eigen::Index n, double mass_of_each, double density, CellOrder cells)
      : count(n),
        mass(mass_of_each),
        X(Scalars::Zero(n + 1)),
        Y(Scalars::Zero(n + 1)),
        vx(Scalars::Zero(n + 1)),
        vy(Scalars::Zero(n + 1)),
        specific_volume(Scalars::Constant(n + 1, 1 / density)),
        stress(n + 1),
        number(n + 1),
        order(std::move(cells)) {}

  int spare() const { return static_cast<int>(count); }

  void copy(int from, int to) {
    for (Scalars* field : {&X, &Y, &vx, &vy, &specific_volume}) (*field)[to] = (*field)[from];
    stress.copy(from, to);
    number[to] = number[from];
  }
};

}  // namespace touchstone::mpm
