#pragma once
/// What goes from particles to nodes and back in the affine method. A cell is summed over its particles before it meets
/// its nine nodes, and its velocities are laid out once for all its particles: equal, but for rounding, to a loop over
/// particles and nodes.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/mpm/affine_sums.hpp"

namespace touchstone::mpm {

/// Masses and momenta that a cell gives to the three nodes of each of three rows, the first of them at `column`.
[[gnu::flatten]] inline void scatter_cell(const AffineParticles& particles, int begin, int end,
                                          const std::array<Share*, 3>& rows, int column) {
  const auto one = sum_over(particles, begin, end, []<class Basis>(const Basis& X) {
    return std::pair{decltype(X.xi){} + 1.0, decltype(X.xi){}};
  });
  const auto xi = sum_over(particles, begin, end, []<class Basis>(const Basis& X) {
    return std::pair{X.xi, decltype(X.xi){} + 1.0};
  });
  const auto even = sum_over(particles, begin, end, []<class Basis>(const Basis& X) {
    return std::pair{X.even, X.lever};
  });
  std::array<std::array<Share, 3>, 3> along_x;  // of each function of Y, at each node column
  for (int n = 0; n < 3; ++n) along_x[n] = QuadraticBSpline::at_nodes<Share>(one[n], xi[n], even[n]);
  for (int a = 0; a < 3; ++a) {
    const auto shares = QuadraticBSpline::at_nodes<Share>(along_x[0][a], along_x[1][a], along_x[2][a]);
    for (int b = 0; b < 3; ++b) rows[b][column + a] += shares[b];
  }
}

/// Masses and momenta of the nodes.
inline void scatter_row(const AffineParticles& particles, const Grid& grid, int row, CentreNodes& nodes) {
  const CellOrder& order = particles.order;
  const std::array<Share*, 3> rows{nodes.given(row, 0), nodes.given(row, 1), nodes.given(row, 2)};
  nodes.clear(row);
  for (int column = nodes.cells(row).begin; column < nodes.cells(row).end; ++column) {
    const int cell = grid.cell_at(column, row);
    if (order.begin(cell) < order.end(cell)) scatter_cell(particles, order.begin(cell), order.end(cell), rows, column);
  }
}

inline void scatter(const AffineParticles& particles, const Grid& grid, CentreNodes& nodes) {
  for (int row = 0; row < grid.rows; ++row) scatter_row(particles, grid, row, nodes);
}

/// Adds to the particles' velocities what a body force that differs from place to place gives them in a step.
template <class Force>
void push_particles(AffineParticles& particles, const Grid& grid, const Force& body_force, double time, double dt) {
  for (int cell : particles.order.occupied())
    for (int slot = particles.order.begin(cell); slot < particles.order.end(cell); ++slot) {
      const Vec2 dv = dt * body_force(grid.place(cell, particles.X[slot], particles.Y[slot]), time);
      particles.x.v[slot] += dv.x();
      particles.y.v[slot] += dv.y();
    }
}

/// One component of the velocity within a cell: for each function of X, what it is multiplied by along Y.
template <class Real>
struct VelocityWithin {
  QuadraticBSpline::Along<Real> one, xi, even;

  struct At {
    Real v, along_x, along_y;  // m/s; slopes per cell, as the affine velocity has them
  };
  At operator()(const QuadraticBSpline::Basis<Real>& X, const QuadraticBSpline::Basis<Real>& Y) const {
    const Real v_one = Y.of(one), v_xi = Y.of(xi), v_even = Y.of(even);
    return {v_one + X.xi * v_xi + X.even * v_even, v_xi + X.lever * v_even,
            Y.slope_of(one) + X.xi * Y.slope_of(xi) + X.even * Y.slope_of(even)};
  }
};

template <class Real>
VelocityWithin<Real> velocity_within(const CentreNodes& nodes, int node, int component) {
  using Along = QuadraticBSpline::Along<Real>;
  const auto row = [&](int at) {
    const auto v = [&](int a) { return Real{} + nodes.velocity[at + a][component]; };
    return Along(v(0), v(1), v(2));
  };
  const Along low = row(node), here = row(node + nodes.columns), high = row(node + 2 * nodes.columns);
  const Along one(low.one, here.one, high.one), xi(low.xi, here.xi, high.xi), even(low.even, here.even, high.even);
  return {one, xi, even};
}

/// What the stress of a fluid takes from what a particle gives, the stress being of the density and the velocity
/// gradient just found: dt / cell stress / density, along x and along y.
template <class Real, class FluidLaw>
void give(AffineParticles& particles, int slot, const FluidLaw& fluid, const Real& specific_volume,
          const Vec2& per_cell, double dt, const typename VelocityWithin<Real>::At& x,
          const typename VelocityWithin<Real>::At& y) {
  const Vec2 impulse = dt * per_cell;
  const Real p = fluid.pressure(Real(1 / specific_volume));
  Real xx = -p, yy = -p, xy{};
  if constexpr (Viscous<FluidLaw>) {
    const double mu = fluid.viscosity;
    const Real v_xx = per_cell.x() * x.along_x, v_yy = per_cell.y() * y.along_y;
    const Real bulk = 2 * mu / 3 * (v_xx + v_yy);
    xx += 2 * mu * v_xx - bulk;
    yy += 2 * mu * v_yy - bulk;
    xy = mu * (per_cell.y() * x.along_y + per_cell.x() * y.along_x);
  }
  store<Real>(0.25 * x.along_x - impulse.x() * specific_volume * xx, particles.x.along_x, slot);
  store<Real>(0.25 * y.along_y - impulse.y() * specific_volume * yy, particles.y.along_y, slot);
  store<Real>(0.25 * x.along_y - impulse.y() * specific_volume * xy, particles.x.along_y, slot);
  store<Real>(0.25 * y.along_x - impulse.x() * specific_volume * xy, particles.y.along_x, slot);
}

/// Velocity, place, density and what comes of them; true if particles are still in their cell and their densities are
/// plausible.
template <class Real, class FluidLaw>
Truth<Real> take(const VelocityWithin<Real>& of_x, const VelocityWithin<Real>& of_y, const Vec2& per_cell, double dt,
                 const FluidLaw& fluid, AffineParticles& particles, int slot) {
  const Real X = load<Real>(particles.X, slot), Y = load<Real>(particles.Y, slot);
  const QuadraticBSpline::Basis<Real> basis_x(X), basis_y(Y);
  const auto x = of_x(basis_x, basis_y), y = of_y(basis_x, basis_y);
  store<Real>(x.v, particles.x.v, slot);
  store<Real>(y.v, particles.y.v, slot);
  const Real new_X = X + dt * per_cell.x() * x.v, new_Y = Y + dt * per_cell.y() * y.v;
  store<Real>(new_X, particles.X, slot);
  store<Real>(new_Y, particles.Y, slot);
  const Real divergence = per_cell.x() * x.along_x + per_cell.y() * y.along_y;
  const Real specific_volume = load<Real>(particles.specific_volume, slot) * (1 + dt * divergence);
  store<Real>(specific_volume, particles.specific_volume, slot);
  give<Real>(particles, slot, fluid, specific_volume, per_cell, dt, x, y);
  return between(0, new_X, 1) & between(0, new_Y, 1) &
         between(least_density, Real(1 / (fluid.density * specific_volume)), most_density);
}

template <class FluidLaw>
[[gnu::flatten]] bool gather_cell(const CentreNodes& nodes, int node, const Vec2& per_cell, double dt,
                                  const FluidLaw& fluid, AffineParticles& particles, int begin, int end) {
  int slot = begin;
  bool calm = true;
  if (end - begin >= lanes) {
    const auto x = velocity_within<Lanes>(nodes, node, 0), y = velocity_within<Lanes>(nodes, node, 1);
    Truth<Lanes> each = Lanes{} == Lanes{};
    for (; slot + lanes <= end; slot += lanes) each &= take<Lanes>(x, y, per_cell, dt, fluid, particles, slot);
    calm = all(each);
  }
  if (slot < end) {
    const auto x = velocity_within<double>(nodes, node, 0), y = velocity_within<double>(nodes, node, 1);
    for (; slot < end; ++slot) calm &= take<double>(x, y, per_cell, dt, fluid, particles, slot);
  }
  return calm;
}

/// Everything that the particles take from the nodes. `suspects` becomes the list of cells in which a particle may have
/// left its cell or have an implausible density; not a number is among the latter.
template <class FluidLaw>
void gather(const CentreNodes& nodes, const Grid& grid, const FluidLaw& law, double dt, AffineParticles& particles,
            std::vector<int>& suspects) {
  const FluidLaw fluid = law;  // a copy, known not to change while particles are written
  const Vec2 per_cell = grid.cell.cwiseInverse();
  const CellOrder& order = particles.order;
  suspects.clear();
  for (int cell : order.occupied())
    if (!gather_cell(nodes, nodes.at(cell % grid.columns, cell / grid.columns), per_cell, dt, fluid, particles,
                     order.begin(cell), order.end(cell)))
      suspects.push_back(cell);
}

}  // namespace touchstone::mpm
