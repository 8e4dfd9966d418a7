#pragma once
#include "solvers/integrators/fluid_state.hpp"
#include "solvers/mpm/cell_order.hpp"
#include "solvers/mpm/fields.hpp"
#include "solvers/mpm/lanes/quadratic_weights.hpp"
#include "solvers/mpm/seed.hpp"

namespace touchstone::mpm {

/// The state in the order of the cells around the nodes, as an integrator moves it. Slots without a particle are zero
/// throughout, and so are their rates.
struct FittedParticles : FluidState {
  Field<double> X, Y;  // cells  from the middle of its cell, where the node is
  Field<int> number;   // as seeded
  CellOrder<lanes> order{1, 1, {}};

  /// From the nodes along an axis, of a register of particles.
  Monomials place(int axis, int slot) const { return Monomials(load<Lanes>(&(axis == 0 ? X : Y)[slot])); }

  template <class F>
  void for_fields(const F& f) {
    for (Scalars* field :
         {&x, &y, &vx, &vy, &rho, &ax, &ay, &drho, &start.x, &start.y, &start.vx, &start.vy, &start.rho})
      f(*field);
    for (Scalars& field : past) f(field);
    f(X), f(Y), f(number);
  }

  /// Puts particles where they are listed; all else is zero.
  void lay_out(const Vectors& places, const Grid& grid) {
    const std::vector<int> cells = cells_of(places, grid);
    order = {grid.columns, grid.rows, cells};
    fluid = order.slots();
    for_fields([&]<class F>(F& field) {
      field.resize(fluid);
      std::fill_n(&field[0], fluid, 0);
    });
    std::vector<int> taken(grid.cells(), 0);
    for (int p = 0; p < places.cols(); ++p) {
      const int slot = order.slot(cells[p], taken[cells[p]]++);
      number[slot] = p;
      x[slot] = places(0, p);
      y[slot] = places(1, p);
    }
  }
};

}  // namespace touchstone::mpm
