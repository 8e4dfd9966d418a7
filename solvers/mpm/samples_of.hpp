#pragma once
#include "solvers/mpm/grid.hpp"
#include "solvers/samples.hpp"

namespace touchstone::mpm {

/// The particles at a time [s], in the order in which they were seeded.
template <class Particles, class FluidLaw>
Samples samples_of(const Particles& particles, const Grid& grid, const FluidLaw& fluid, double time) {
  const Eigen::Index n = particles.count;
  Samples s{time, Vectors(2, n), Vectors(2, n), Scalars::Constant(n, particles.mass), Scalars(n), Scalars(n)};
  particles.order.for_each([&](int cell, int slot) {
    const int p = particles.number[slot];
    s.x.col(p) = grid.place(cell, particles.X[slot], particles.Y[slot]);
    s.v.col(p) = particles.velocity(slot);
    s.density[p] = fluid.density / (1 + static_cast<double>(particles.expansion[slot]));
    s.pressure[p] = fluid.pressure(s.density[p]);
  });
  return s;
}

}  // namespace touchstone::mpm
