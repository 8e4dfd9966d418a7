#pragma once
/// Particles that are set going as a scene says.

#include "solvers/lattice.hpp"
#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/stress.hpp"

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

/// The fluid at a place when the run starts.
struct Beginning {
  Vec2 v;             // m/s
  double expansion;   // -    rho0 / rho - 1
  Slopes<double> of;  // 1/s  of the velocity
};

/// How a field changes along an axis, by central differences over a thousandth of a cell, within the box.
template <class Field>
auto slope_along(int axis, const Vec2& x, const Grid& grid, const Field& field) -> decltype(field(x)) {
  const double reach = 1e-3 * grid.cell[axis];
  Vec2 from = x, to = x;
  from[axis] = std::max(x[axis] - reach, grid.box.low[axis]);
  to[axis] = std::min(x[axis] + reach, grid.box.high[axis]);
  return (field(to) - field(from)) / (to[axis] - from[axis]);
}

template <class FluidLaw>
double expansion_at(const Vec2& x, const Start& start, const FluidLaw& fluid) {
  return fluid.density / fluid.density_at(start.pressure_at(x)) - 1;
}

template <class FluidLaw>
Beginning beginning_at(const Vec2& x, const Start& start, const Grid& grid, const FluidLaw& fluid) {
  const auto velocity = [&](const Vec2& at) { return start.velocity_at(at); };
  const Vec2 along_x = slope_along(0, x, grid, velocity), along_y = slope_along(1, x, grid, velocity);
  return {.v = start.velocity_at(x),
          .expansion = expansion_at(x, start, fluid),
          .of = {.xx = along_x.x(), .yx = along_x.y(), .xy = along_y.x(), .yy = along_y.y()}};
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

/// Whether fluid of a mass [kg/m] has room in its domain to come apart: it fills it otherwise.
template <class FluidLaw, class Force>
bool has_room(double mass, const Scene<FluidLaw, Force>& scene) {
  return mass < 0.999 * scene.fluid.density * scene.domain.box.size().prod();
}

}  // namespace touchstone::mpm
