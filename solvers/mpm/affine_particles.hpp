#pragma once
#include "solvers/lattice.hpp"
#include "solvers/mpm/seed.hpp"

namespace touchstone::mpm {

/// The state of all particles of the affine method, component by component, in the order of their cells; places and
/// slots without a particle as in `Particles`.
///
/// What a particle gives to a node is its velocity and four times the lever of the node times `along_x` and `along_y`:
/// a quarter of what the affine velocity C gains over a cell, less what the stress takes from it in a step,
/// (C - 4 dt / cell² stress / density) cell / 4. Neither C nor the stress is needed by itself.
template <class Number = double>
struct AffineParticles {
  struct Component {
    Field<Number> v;                 // m/s
    Field<Number> along_x, along_y;  // m/s  per cell, over four

    explicit Component(int slots) : v(slots), along_x(v), along_y(v) {}
  };

  Eigen::Index count;
  double mass;              // kg/m   of each
  Field<Number> X, Y;       // -      place within the cell, 0 to 1
  Component x, y;           // of the velocity
  Field<Number> expansion;  // -      rho0 / rho - 1
  Field<int> number;        // as seeded; the same at all times
  CellOrder<lanes_of<Number>> order;

  /// At rest, with places and numbers yet to be written.
  AffineParticles(Eigen::Index n, double mass_of_each, CellOrder<lanes_of<Number>> cells)
      : count(n),
        mass(mass_of_each),
        X(cells.slots()),
        Y(X),
        x(cells.slots()),
        y(cells.slots()),
        expansion(X),
        number(cells.slots()),
        order(std::move(cells)) {}

  void copy(int from, int to) {
    for_fields([=](auto& field) { field[to] = field[from]; });
  }
  void clear(int slot) {
    for_fields([=](auto& field) { field[slot] = 0; });
  }
  /// Moves runs of slots, and makes them so many.
  void rearrange(const std::vector<Move>& moves, int slots) {
    for_fields([&]<class F>(F& field) {
      F fresh(slots);
      for (const Move& move : moves) std::copy_n(&field[move.from], move.slots, &fresh[move.to]);
      field.swap(fresh);
    });
  }

 private:
  template <class F>
  void for_fields(const F& f) {
    for (Field<Number>* field : {&X, &Y, &x.v, &x.along_x, &x.along_y, &y.v, &y.along_x, &y.along_y, &expansion})
      f(*field);
    f(number);
  }
};

/// Particles at rest at the points of a lattice, in the order of their cells.
template <class Number, class FluidLaw>
AffineParticles<Number> affine_at_rest(const Lattice& points, const Grid& grid, const FluidLaw& fluid) {
  const Vectors places = points.places();
  const std::vector<int> cells = cells_of(places, grid);
  AffineParticles<Number> particles(places.cols(), fluid.density * points.volume(),
                                    CellOrder<lanes_of<Number>>(grid.columns, grid.rows, cells));
  std::vector<int> taken(grid.cells(), 0);
  for (int p = 0; p < particles.count; ++p) {
    const int slot = particles.order.slot(cells[p], taken[cells[p]]++);
    const Eigen::Array2d within = (places.col(p) - grid.place(cells[p], 0, 0)).array() / grid.cell.array();
    particles.X[slot] = static_cast<Number>(within.x());
    particles.Y[slot] = static_cast<Number>(within.y());
    particles.number[slot] = p;
  }
  return particles;
}

}  // namespace touchstone::mpm
