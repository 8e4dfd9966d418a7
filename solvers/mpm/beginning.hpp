#pragma once
/// Particles that are set going as a scene says.

#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/stress.hpp"

#include <algorithm>

namespace touchstone::mpm {

/// The fluid at a place when the run starts.
struct Beginning {
  Vec2 v;             // m/s
  double expansion;   // -    rho0 / rho - 1
  Slopes<double> of;  // 1/s  of the velocity
};

/// Slopes by central differences over a thousandth of a cell, within the box.
template <class FluidLaw>
Beginning beginning_at(const Vec2& x, const Start& start, const Grid& grid, const FluidLaw& fluid) {
  Vec2 along[2];
  for (const int axis : {0, 1}) {
    const double reach = 1e-3 * grid.cell[axis];
    Vec2 from = x, to = x;
    from[axis] = std::max(x[axis] - reach, grid.box.low[axis]);
    to[axis] = std::min(x[axis] + reach, grid.box.high[axis]);
    along[axis] = (start.velocity_at(to) - start.velocity_at(from)) / (to[axis] - from[axis]);
  }
  return {.v = start.velocity_at(x),
          .expansion = fluid.density / fluid.density_at(start.pressure_at(x)) - 1,
          .of = {.xx = along[0].x(), .yx = along[0].y(), .xy = along[1].x(), .yy = along[1].y()}};
}

/// `begin` belongs to the kind of particles; `dt` is the step that follows.
template <class Particles, class FluidLaw>
void set_going(Particles& particles, const Start& start, const Grid& grid, const FluidLaw& fluid, double dt) {
  if (start.at_rest()) return;
  particles.order.for_each([&](int cell, int slot) {
    const Vec2 x = grid.place(cell, particles.X[slot], particles.Y[slot]);
    begin(particles, slot, beginning_at(x, start, grid, fluid), fluid, grid.cell, dt);
  });
}

/// Writes the first lane, as if it were a number.
struct FirstLane {
  template <class Real>
  void operator()(const Real& value, NumberIn<Real>* to) const {
    *to = value[0];
  }
};

}  // namespace touchstone::mpm
