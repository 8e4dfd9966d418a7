#pragma once
#include "solvers/fields.hpp"

#include <vector>

namespace touchstone {

/// What an integrator moves: places, velocities and densities of the particles of a fluid, and how they change.
struct FluidState {
  Index fluid = 0;            // particles; what else a method keeps stands behind them
  Scalars x, y;               // m
  Scalars vx, vy, rho;        // m/s, kg/m³
  Scalars ax, ay, drho;       // m/s², kg/m³ s
  std::vector<Scalars> past;  // fields of the integrator that go with the particles

  struct Motion {
    Scalars x, y, vx, vy, rho;
  };
  Motion start;  // of a step, where an integrator comes back to it
};

}  // namespace touchstone
