#pragma once
#include "solvers/mpm/grid.hpp"
#include "solvers/samples.hpp"
#include "solvers/stepping/extremes.hpp"

namespace touchstone::mpm {

/// The particles at a time [s], in the order in which they were seeded.
template <class Particles, class FluidLaw>
Samples samples_of(const Particles& particles, const Grid& grid, const FluidLaw& fluid, double time) {
  Samples s = Samples::of_equal(time, particles.count, particles.mass);
  particles.order.for_each([&](int cell, int slot) {
    const int p = particles.number[slot];
    s.x.col(p) = grid.place(cell, particles.X[slot], particles.Y[slot]);
    s.v.col(p) = particles.velocity(slot);
    s.density[p] = fluid.density / (1 + static_cast<double>(particles.expansion[slot]));
    s.pressure[p] = fluid.pressure(s.density[p]);
  });
  return s;
}

/// Of the particles; a slot without one is at rest with the density of rest.
template <class Particles, class FluidLaw>
Extremes extremes_of(const Particles& particles, const FluidLaw& fluid) {
  double square = 0, expansion = 0;
  for (int slot = 0; slot < particles.order.slots(); ++slot) {
    square = std::max(square, particles.velocity(slot).squaredNorm());
    expansion = std::min(expansion, static_cast<double>(particles.expansion[slot]));
  }
  return {std::sqrt(square), fluid.density / (1 + expansion)};
}

}  // namespace touchstone::mpm
