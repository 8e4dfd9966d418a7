#pragma once
#include "solvers/fields.hpp"
#include "solvers/mpm/cell_order.hpp"
#include "solvers/mpm/fields.hpp"
#include "solvers/mpm/lanes.hpp"

namespace touchstone::mpm {

/// The state of all particles of the affine method, component by component, in the order of their cells; places and
/// slots without a particle as in `Particles`.
///
/// What a particle gives to a node is its velocity and four times the lever of the node times `along_x` and `along_y`:
/// a quarter of what the affine velocity C gains over a cell, less what the stress takes from it in a step,
/// (C - 4 dt / cell² stress / density) cell / 4. Neither C nor the stress is needed by itself.
template <class Number_ = double>
struct AffineParticles {
  using Number = Number_;

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

  Vec2 velocity(int slot) const { return {x.v[slot], y.v[slot]}; }  // m/s

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

}  // namespace touchstone::mpm
