#pragma once
#include "solvers/mpm/particles.hpp"
#include "solvers/mpm/stress.hpp"

namespace touchstone::mpm {

/// The state of all particles of the printed method.
template <class FluidLaw, class Number = double>
struct PrintedParticles : ParticlesInCells<Number> {
  Field<Number> vx, vy;  // m/s
  Stress<FluidLaw, Number> stress;

  PrintedParticles(Eigen::Index n, double mass_of_each, CellOrder<lanes_of<Number>> cells)
      : ParticlesInCells<Number>(n, mass_of_each, std::move(cells)),
        vx(this->X),
        vy(this->X),
        stress(this->order.slots()) {}

  Vec2 velocity(int slot) const { return {vx[slot], vy[slot]}; }  // m/s

  template <class F>
  void for_fields(const F& f) {
    for (Field<Number>* field : {&this->X, &this->Y, &vx, &vy, &this->expansion}) f(*field);
    stress.for_fields(f);
    f(this->number);
  }
};

}  // namespace touchstone::mpm
