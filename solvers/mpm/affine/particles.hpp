#pragma once
#include "solvers/mpm/particles.hpp"

namespace touchstone::mpm {

/// The state of all particles of the affine method.
///
/// What a particle gives to a node is its velocity and four times the lever of the node times `along_x` and `along_y`:
/// a quarter of what the affine velocity C gains over a cell, less what the stress takes from it in a step,
/// (C - 4 dt / cell² stress / density) cell / 4. Neither C nor the stress is needed by itself.
template <class Number = double>
struct AffineParticles : ParticlesInCells<Number> {
  struct Component {
    Field<Number> v;                 // m/s
    Field<Number> along_x, along_y;  // m/s  per cell, over four

    explicit Component(int slots) : v(slots), along_x(v), along_y(v) {}
  };

  Component x, y;  // of the velocity

  AffineParticles(Eigen::Index n, double mass_of_each, CellOrder<lanes_of<Number>> cells)
      : ParticlesInCells<Number>(n, mass_of_each, std::move(cells)), x(this->order.slots()), y(this->order.slots()) {}

  Vec2 velocity(int slot) const { return {x.v[slot], y.v[slot]}; }  // m/s

  template <class F>
  void for_fields(const F& f) {
    for (Field<Number>* field :
         {&this->X, &this->Y, &x.v, &x.along_x, &x.along_y, &y.v, &y.along_x, &y.along_y, &this->expansion})
      f(*field);
    f(this->number);
  }
};

}  // namespace touchstone::mpm
