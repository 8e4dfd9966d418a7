#pragma once
#include "solvers/mpm/cell_order.hpp"
#include "solvers/mpm/stress.hpp"

namespace touchstone::mpm {

/// What a density may be, in densities at rest, before a run counts as diverged: far beyond what Tait's law is for.
inline constexpr double least_density = 0.2, most_density = 5;

/// The state of all particles, component by component, in the order of their cells.
///
/// A place is kept within its cell, which the order knows, so that a wrap across the seam loses no digit. All particles
/// of a scene have the same mass; it cancels from (10) to (17) and is left out of them. A slot without a particle holds
/// a particle at rest in the corner of its cell: but for its mass it adds nothing to any sum.
template <class FluidLaw, class Number_ = double>
struct Particles {
  using Number = Number_;

  Eigen::Index count;
  double mass;              // kg/m   of each
  Field<Number> X, Y;       // -      place within the cell, 0 to 1
  Field<Number> vx, vy;     // m/s
  Field<Number> expansion;  // -      rho0 / rho - 1
  Stress<FluidLaw, Number> stress;
  Field<int> number;  // as seeded; the same at all times
  CellOrder<lanes_of<Number>> order;

  /// At rest, with places and numbers yet to be written.
  Particles(Eigen::Index n, double mass_of_each, CellOrder<lanes_of<Number>> cells)
      : count(n),
        mass(mass_of_each),
        X(cells.slots()),
        Y(X),
        vx(X),
        vy(X),
        expansion(X),
        stress(cells.slots()),
        number(cells.slots()),
        order(std::move(cells)) {}

  Vec2 velocity(int slot) const { return {vx[slot], vy[slot]}; }  // m/s

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
    for (Field<Number>* field : {&X, &Y, &vx, &vy, &expansion}) f(*field);
    stress.for_fields(f);
    f(number);
  }
};

}  // namespace touchstone::mpm
