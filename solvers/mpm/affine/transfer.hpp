#pragma once
/// What goes from particles to nodes and back in the affine method. A block of neighbouring cells is summed over its
/// particles, one cell a lane, before the cells meet their nine nodes, and velocities are laid out once for all
/// particles of a block: equal, but for rounding, to a loop over particles and nodes.

#include "solvers/mpm/affine/nodes.hpp"
#include "solvers/mpm/affine/sums.hpp"
#include "solvers/mpm/printed/transfer.hpp"

namespace touchstone::mpm {

/// What a block of cells gives to its rows of nodes.
template <class Number, class Block>
[[gnu::flatten]] void give(const AffineParticles<Number>& particles, const Block& block, GivenByCells<3, 3>& to) {
  const std::array given{mass_of(particles, block), momentum_of(particles, particles.x, block),
                         momentum_of(particles, particles.y, block)};
  const auto give_part = [&]<int part>(std::integral_constant<int, part>) {
    for (int field = 0; field < 3; ++field)
      to.give(field, block.column + part * lanes, at_nodes(widened<part>(given[field])));
  };
  with_indices<lanes_of<Number> / lanes>([&](auto... part) { (give_part(part), ...); });
}

/// Masses and momenta of the nodes, as they are given by the rows of cells.
template <class Number>
void scatter(const AffineParticles<Number>& particles, int threads, AffineNodes& nodes) {
  give_by_rows<3>(particles.order, threads, nodes,
                  [&](int, const auto& block, auto& to) { give(particles, block, to); });
}

/// One component of the velocity within the cells of a block: for each function of X, a field along Y.
template <class Real>
struct VelocityWithin {
  using Along = QuadraticBSpline::Along<Real>;
  using Basis = QuadraticBSpline::Basis<Real>;
  Along one, xi, even;

  struct At {
    Real v, along_x, along_y;  // m/s; slopes per cell, as the affine velocity has them
  };
  At operator()(const Basis& X, const Basis& Y) const {
    const Real v_one = Y.of(one), v_xi = Y.of(xi), v_even = Y.of(even);
    return {v_one + X.xi * v_xi + X.even * v_even, v_xi + X.lever * v_even,
            Y.slope_of(one) + X.xi * Y.slope_of(xi) + X.even * Y.slope_of(even)};
  }
};

template <class Real>
VelocityWithin<Real> velocity_within(const Field<double>& velocity, int node, int stride) {
  using Along = QuadraticBSpline::Along<Real>;
  const auto v = [&](int at) { return joined<Real>([&](int lane) { return load<Lanes>(&velocity[at + lane]); }); };
  const auto row = [&](int at) { return Along(v(at), v(at + 1), v(at + 2)); };
  const Along low = row(node), here = row(node + stride), high = row(node + 2 * stride);
  return {Along(low.one, here.one, high.one), Along(low.xi, here.xi, high.xi), Along(low.even, here.even, high.even)};
}

/// What the stress takes from what a particle gives to the nodes, dt / cell stress / density; the stress (32), (33) is
/// that of the density and the velocity gradient just found.
template <class Real, class FluidLaw>
struct StressImpulse {
  Real x_along_x, shear_along_x, shear_along_y, y_along_y;  // m/s

  template <class At>
  StressImpulse(const FluidLaw& fluid, const Real& expansion, const At& x, const At& y, const Vec2& per_cell,
                double dt) {
    const Real specific_volume = fill<Real>(1 / fluid.density) * (1 + expansion);
    const Real along_x = fill<Real>(dt * per_cell.x()) * specific_volume,
               along_y = fill<Real>(dt * per_cell.y()) * specific_volume;
    const Real p = pressure_of(fluid, expansion);
    Real xx = -p, yy = -p, xy{};
    if constexpr (Viscous<FluidLaw>) {
      const Real mu_x = fill<Real>(fluid.viscosity * per_cell.x()), mu_y = fill<Real>(fluid.viscosity * per_cell.y());
      const Real mu_xx = mu_x * x.along_x, mu_yy = mu_y * y.along_y;
      const Real bulk = fill<Real>(2.0 / 3) * (mu_xx + mu_yy);
      xx += 2 * mu_xx - bulk;
      yy += 2 * mu_yy - bulk;
      xy = mu_y * x.along_y + mu_x * y.along_x;
    }
    x_along_x = along_x * xx;
    shear_along_x = along_x * xy;
    shear_along_y = along_y * xy;
    y_along_y = along_y * yy;
  }
};

/// What a particle keeps of a velocity and its slopes, and of a density.
template <class Real, class Number, class At, class FluidLaw, class Write>
void keep(AffineParticles<Number>& particles, int slot, const Real& expansion, const At& x, const At& y,
          const Vec2& per_cell, double dt, const FluidLaw& fluid, const Write& write) {
  const StressImpulse<Real, FluidLaw> stress(fluid, expansion, x, y, per_cell, dt);
  write(x.v, &particles.x.v[slot]);
  write(y.v, &particles.y.v[slot]);
  write(expansion, &particles.expansion[slot]);
  write(0.25 * x.along_x - stress.x_along_x, &particles.x.along_x[slot]);
  write(0.25 * x.along_y - stress.shear_along_y, &particles.x.along_y[slot]);
  write(0.25 * y.along_x - stress.shear_along_x, &particles.y.along_x[slot]);
  write(0.25 * y.along_y - stress.y_along_y, &particles.y.along_y[slot]);
}

/// Velocity, place, density and what comes of them; true if the particles are still in their cells and their densities
/// are plausible.
template <class Real, class Number, class FluidLaw, class Write>
Truth<Real> take(AffineParticles<Number>& particles, int slot, const VelocityWithin<Real>& of_x,
                 const VelocityWithin<Real>& of_y, const Vec2& per_cell, double dt, const FluidLaw& fluid,
                 const Write& write) {
  const Real X = load<Real>(&particles.X[slot]), Y = load<Real>(&particles.Y[slot]);
  const QuadraticBSpline::Basis<Real> along_X(X), along_Y(Y);
  const auto x = of_x(along_X, along_Y), y = of_y(along_X, along_Y);
  const Real cells_x = fill<Real>(dt * per_cell.x()), cells_y = fill<Real>(dt * per_cell.y());
  const Real new_X = X + cells_x * x.v, new_Y = Y + cells_y * y.v;
  const Real before = load<Real>(&particles.expansion[slot]);
  const Real after = before + (1 + before) * (cells_x * x.along_x + cells_y * y.along_y);
  keep<Real>(particles, slot, after, x, y, per_cell, dt, fluid, write);
  write(new_X, &particles.X[slot]);
  write(new_Y, &particles.Y[slot]);
  return write.unless_absent(between(0, new_X, 1) & between(0, new_Y, 1) &
                             between(1 / most_density, 1 + after, 1 / least_density));
}

/// Sets a particle going, with the affine velocity of its velocity's slopes and the stress of these and its density.
template <class Number, class FluidLaw>
void begin(AffineParticles<Number>& particles, int slot, const Beginning& there, const FluidLaw& fluid,
           const Vec2& cell, double dt) {
  using Real = LanesOf<Number>;
  const auto lanes_with = [](double number) { return fill<Real>(number); };
  const typename VelocityWithin<Real>::At x{lanes_with(there.v.x()), lanes_with(cell.x() * there.of.xx),
                                            lanes_with(cell.y() * there.of.xy)},
      y{lanes_with(there.v.y()), lanes_with(cell.x() * there.of.yx), lanes_with(cell.y() * there.of.yy)};
  keep<Real>(particles, slot, fill<Real>(there.expansion), x, y, cell.cwiseInverse(), dt, fluid, FirstLane{});
}

/// Everything that the particles take from the nodes. `calm` tells of each block in which cells all particles are
/// still there, and of a plausible density; not a number is neither.
template <class Number, class FluidLaw>
void gather(const AffineNodes& nodes, const Grid& grid, const FluidLaw& law, double dt, int threads,
            AffineParticles<Number>& particles, std::vector<LaneBits>& calm) {
  using Real = LanesOf<Number>;
  const auto& blocks = particles.order.blocks();
  calm.resize(blocks.size());
  const auto gather_block = [&](int i) __attribute__((flatten)) {
    const FluidLaw fluid = law;  // a copy, known not to change while particles are written
    const Vec2 per_cell = grid.cell.cwiseInverse();
    const int node = nodes.stride * blocks[i].row + blocks[i].column;
    const auto x = velocity_within<Real>(nodes.velocity.x, node, nodes.stride);
    const auto y = velocity_within<Real>(nodes.velocity.y, node, nodes.stride);
    calm[i] = for_all<Real>(blocks[i], [&](int slot, const auto& write) {
      return take<Real>(particles, slot, x, y, per_cell, dt, fluid, write);
    });
  };
  share_out(threads, static_cast<Eigen::Index>(blocks.size()), [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) gather_block(static_cast<int>(i));
  });
}

}  // namespace touchstone::mpm
