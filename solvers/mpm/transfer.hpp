#pragma once
/// What goes from particles to nodes and back. A cell is summed over its particles before it meets its corners, and its
/// fields are laid out once for all its particles: equal, but for rounding, to a loop over particles and nodes.
///
/// A shape of degree one within a cell plugs in with its moments, corners and fields as `LinearHat` does. A wider one,
/// whose cells touch more nodes, needs higher moments too: its own `CellSums`, `scatter`, `add_changes` and `gather`.

#include "solvers/mpm/cell_sums.hpp"
#include "solvers/mpm/nodes.hpp"

namespace touchstone::mpm {

/// Masses, momenta and internal forces (12) of the nodes; keeps what each cell weighs for `add_changes`.
template <class Shape, class FluidLaw>
[[gnu::flatten]] void scatter(const Particles<FluidLaw>& particles, const Grid& grid,
                              std::vector<CellMass<double>>& masses, Nodes& nodes) {
  const CellOrder& order = particles.order;
  const Vec2 per_cell = grid.cell.cwiseInverse();
  for (int cell : order.occupied()) {
    const CellSums<FluidLaw, double> sums = sum_over(particles, order.begin(cell), order.end(cell));
    masses[cell] = sums.mass;
    const auto mass = Shape::template at_corners<double>(
        {1.0 * order.count(cell), sums.mass.X_Y.x(), sums.mass.X_Y.y(), sums.mass.XY_XXYY.x()});
    const auto momentum = Shape::template at_corners<Vec2>({sums.v, sums.Xv, sums.Yv, sums.XYv});
    const auto force = sums.stress.template forces<Shape>(per_cell);
    for (int corner = 0; corner < 4; ++corner) {
      NodeSums& node = nodes.sums[grid.corners[cell][corner]];
      node.mass += mass[corner];
      node.momentum += momentum[corner];
      node.force += force[corner];
    }
  }
}

/// Adds the body forces on the particles to those of the nodes (13), for a force that differs from place to place.
template <class Shape, class FluidLaw, class Force>
void scatter_body_force(const Particles<FluidLaw>& particles, const Grid& grid, const Force& body_force, double time,
                        Nodes& nodes) {
  for (int cell : particles.order.occupied())
    for (int slot = particles.order.begin(cell); slot < particles.order.end(cell); ++slot) {
      const double X = particles.X[slot], Y = particles.Y[slot];
      const Vec2 b = body_force(grid.place(cell, X, Y), time);
      const auto force = Shape::template at_corners<Vec2>({b, X * b, Y * b, X * Y * b});
      for (int corner = 0; corner < 4; ++corner) nodes.sums[grid.corners[cell][corner]].force += force[corner];
    }
}

/// A field of the nodes, within a cell.
template <class Shape>
typename Shape::template Within<Vec2> field(const Nodes& nodes, const std::array<int, 4>& corners,
                                            Vec2 NodeMotion::*of) {
  return {nodes.motion[corners[0]].*of, nodes.motion[corners[1]].*of, nodes.motion[corners[2]].*of,
          nodes.motion[corners[3]].*of};
}

/// Adds to the momentum of the nodes what (16) adds to that of the particles, which makes it that of (17):
/// sum_p M_p N_i v_p changes by dt sum_j M_ij a_j with M_ij = sum_p M_p N_i N_j, and each cell knows its share of M_ij.
template <class Shape>
[[gnu::flatten]] void add_changes(const CellOrder& order, const Grid& grid, const std::vector<CellMass<double>>& masses,
                                  Nodes& nodes) {
  for (int cell : order.occupied()) {
    const auto& corners = grid.corners[cell];
    const auto dv = field<Shape>(nodes, corners, &NodeMotion::change);
    const CellMass<double>& m = masses[cell];
    const double one = order.count(cell), X = m.X_Y.x(), Y = m.X_Y.y(), XX = m.XX_YY.x(), YY = m.XX_YY.y();
    const double XY = m.XY_XXYY.x(), XXYY = m.XY_XXYY.y(), XXY = m.XXY_XYY.x(), XYY = m.XXY_XYY.y();
    const auto added = Shape::template at_corners<Vec2>(
        {one * dv.q0 + X * dv.qX + Y * dv.qY + XY * dv.qXY, X * dv.q0 + XX * dv.qX + XY * dv.qY + XXY * dv.qXY,
         Y * dv.q0 + XY * dv.qX + YY * dv.qY + XYY * dv.qXY, XY * dv.q0 + XXY * dv.qX + XYY * dv.qY + XXYY * dv.qXY});
    for (int corner = 0; corner < 4; ++corner) nodes.sums[corners[corner]].momentum += added[corner];
  }
}

template <class Real, class Field>
Pair<Real> at(const Real& X, const Real& Y, const Field& q) {
  return broadcast<Real>(q.q0) + X * broadcast<Real>(q.qX) + Y * (broadcast<Real>(q.qY) + X * broadcast<Real>(q.qXY));
}

/// Strain (18), density and stress (19), from the velocity remapped to the nodes; true if the density is plausible.
template <class Real, class Field, class FluidLaw>
Truth<Real> strain(Particles<FluidLaw>& particles, int slot, const Field& v, const Vec2& per_cell, double dt,
                   const FluidLaw& fluid) {
  const Real X = load<Real>(particles.X, slot), Y = load<Real>(particles.Y, slot);
  const Slopes<Real> of_v{
      (Real{} + per_cell.x()) * (broadcast<Real>(v.qX) + Y * broadcast<Real>(v.qXY)),
      (Real{} + per_cell.y()) * (broadcast<Real>(v.qY) + X * broadcast<Real>(v.qXY)),
  };
  const Real specific_volume = load<Real>(particles.specific_volume, slot) * (1 + dt * of_v.divergence());
  const Real density = 1 / specific_volume;
  store<Real>(specific_volume, particles.specific_volume, slot);
  particles.stress.template update<Real>(slot, fluid, density, of_v);
  return between(least_density * fluid.density, density, most_density * fluid.density);
}

/// Place (15) and velocity (16); true if the particle is still in its cell.
template <class Real, class Field, class FluidLaw>
Truth<Real> move(Particles<FluidLaw>& particles, int slot, const Field& displacement, const Field& change) {
  const Real X = load<Real>(particles.X, slot), Y = load<Real>(particles.Y, slot);
  const Pair<Real> dv = at<Real>(X, Y, change);
  store<Real>(load<Real>(particles.vx, slot) + dv.x(), particles.vx, slot);
  store<Real>(load<Real>(particles.vy, slot) + dv.y(), particles.vy, slot);
  const Pair<Real> dx = at<Real>(X, Y, displacement);
  const Real new_X = X + dx.x(), new_Y = Y + dx.y();
  store<Real>(new_X, particles.X, slot);
  store<Real>(new_Y, particles.Y, slot);
  return between(0, new_X, 1) & between(0, new_Y, 1);
}

/// Does all of `bodies` in turn to the particles of a cell, several at once while there are as many; true if every body
/// says so of every particle.
template <class... Bodies>
bool for_all(int begin, int end, const Bodies&... bodies) {
  int slot = begin;
  bool each = true;
  if (end - begin >= lanes) {
    Truth<Lanes> wide = Lanes{} == Lanes{};
    const auto run = [&](const auto& body) {
      for (slot = begin; slot + lanes <= end; slot += lanes) wide &= body.template operator()<Lanes>(slot);
    };
    (run(bodies), ...);
    each = all(wide);
  }
  for (; slot < end; ++slot) ((each &= bodies.template operator()<double>(slot)), ...);
  return each;
}

/// Everything that the particles take from the nodes. `suspects` becomes the list of cells in which a particle may have
/// left its cell or have an implausible density; not a number is among the latter.
template <class Shape, class FluidLaw>
[[gnu::flatten]] void gather(const Nodes& nodes, const Grid& grid, const FluidLaw& law, double dt,
                             Particles<FluidLaw>& particles, std::vector<int>& suspects) {
  const CellOrder& order = particles.order;
  const FluidLaw fluid = law;  // a copy, known not to change while particles are written
  const Vec2 per_cell = grid.cell.cwiseInverse();
  suspects.clear();
  for (int cell : order.occupied()) {
    const auto& corners = grid.corners[cell];
    const int begin = order.begin(cell), end = order.end(cell);
    const auto v = field<Shape>(nodes, corners, &NodeMotion::remapped);
    const auto displacement = field<Shape>(nodes, corners, &NodeMotion::displacement);
    const auto change = field<Shape>(nodes, corners, &NodeMotion::change);
    const bool calm = for_all(
        begin, end, [&]<class Real>(int slot) { return strain<Real>(particles, slot, v, per_cell, dt, fluid); },
        [&]<class Real>(int slot) { return move<Real>(particles, slot, displacement, change); });
    if (!calm) suspects.push_back(cell);
  }
}

}  // namespace touchstone::mpm
