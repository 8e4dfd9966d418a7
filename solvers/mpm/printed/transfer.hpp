#pragma once
/// What goes from particles to nodes and back. A block of neighbouring cells is summed over its particles, one cell a
/// lane, before the cells meet their corners, and its fields are laid out once for all its particles: equal, but for
/// rounding, to a loop over particles and nodes.
///
/// The shape is `LinearHat`. A wider one, whose cells touch more nodes, needs higher moments too: its own sums,
/// `scatter`, `scatter_changes` and `gather`.

#include "solvers/mpm/beginning.hpp"
#include "solvers/mpm/body_force.hpp"
#include "solvers/mpm/cell_rows.hpp"
#include "solvers/mpm/printed/cell_sums.hpp"
#include "solvers/mpm/printed/nodes.hpp"
#include "solvers/mpm/shapes/linear_hat.hpp"

#include <algorithm>
#include <concepts>

namespace touchstone::mpm {

/// What a row of cells gives to its nodes, block by block from left to right. The nodes between two blocks belong to
/// both: what the one on the left gives them waits for the one on the right.
template <Given first, Given last>
class GivenByRow {
 public:
  GivenByRow(CornerNodes& nodes, int row) : nodes_(nodes), low_(row * nodes.stride), high_(low_ + nodes.stride) {}

  template <Given what>
  void give(int column, const std::array<Lanes, 4>& corners) {
    Waiting& waiting = waiting_[what - first];
    store(corners[0] + shifted<1>(waiting.low, corners[1]), &nodes_.from_above[what][low_ + column]);
    store(corners[2] + shifted<1>(waiting.high, corners[3]), &nodes_.from_below[what][high_ + column]);
    waiting = {corners[1], corners[3]};
  }
  /// Gives what waits to the nodes from `column` on, where no block follows; a row that ends within a block leaves
  /// nothing to give. What waits for a last column that nobody visits is left for `close_boundary`.
  void finish(int column) {
    crosses_ = nodes_.last_column_is_alone_at(column);
    if (crosses_) return;
    if (column == nodes_.stride)
      waiting_.fill({});
    else
      with_indices<last - first + 1>([&](auto... i) { (give<static_cast<Given>(first + i)>(column, {}), ...); });
  }
  /// Adds what both images of a node on a periodic boundary were given.
  void close_boundary() {
    const auto close = [&](auto i) {
      Field<double>&above = nodes_.from_above[first + i], &below = nodes_.from_below[first + i];
      if (crosses_) {
        above[low_] += waiting_[i].low[lanes - 1];
        below[high_] += waiting_[i].high[lanes - 1];
      } else {
        nodes_.join_images(above, low_);
        nodes_.join_images(below, high_);
      }
    };
    for_indices<last - first + 1>(close);
  }

 private:
  struct Waiting {
    Lanes low{}, high{};
  };
  CornerNodes& nodes_;
  int low_, high_;  // the first nodes below and above the row
  bool crosses_ = false;
  std::array<Waiting, last - first + 1> waiting_;
};

/// Calls work(begin, end, block_at) for the blocks of each row. Rows of cells with one particle each have code of their
/// own, in which no loop over particles takes registers.
template <int width, class Work>
void for_rows(const CellOrder<width>& order, int threads, const Work& work) {
  share_out_rows(order, threads, [&](auto row, auto rows_end) {
    for (; row < rows_end; ++row)
      order.with_row(row[0], row[1], [&](const auto& block_at) { work(row[0], row[1], block_at); });
  });
}

/// Has the blocks of each row give to their nodes, `give(index, block, to)`, and closes the periodic boundaries.
template <Given first, Given last, int width, class Give>
void scatter_rows(const CellOrder<width>& order, int threads, CornerNodes& nodes, const Give& give) {
  const auto scatter_row = [&](int begin, int end, const auto& block_at) __attribute__((flatten, noinline)) {
    const int row = block_at(begin).row;
    const bool at_boundary = nodes.at_periodic_boundary(block_at(end - 1).column + width);
    if (at_boundary && block_at(begin).column > 0) nodes.open_boundary(row);
    GivenByRow<first, last> to(nodes, row);
    for (int i = begin; i < end; ++i) {
      give(i, block_at(i), to);
      const int next = block_at(i).column + width;
      if (i + 1 == end || block_at(i + 1).column > next) to.finish(next);
    }
    if (at_boundary) to.close_boundary();
  };
  for_rows(order, threads, scatter_row);
  nodes.join_rows(first, last);
}

/// Sums over the particles of the cells of a block of a body force (13) [m/s²].
template <class Number, class FluidLaw, class Block, Local Force, class Real = LanesOf<Number>>
VectorMoments<Real> body_force_of(const PrintedParticles<FluidLaw, Number>& particles, const Block& block,
                                  const Grid& grid, const Force& force, double time) {
  VectorMoments<Real> sums{};
  for (int lane = 0; lane < lanes_of<Number>; ++lane) {
    VectorMoments<Number> of_cell{};
    for (int k = 0; k < block.count[lane]; ++k) {
      const int slot = block.slot(lane, k);
      const Number X = particles.X[slot], Y = particles.Y[slot];
      const Vec2 b = force(grid.place(particles.order.cell(block, lane), X, Y), time);
      for (const int axis : {0, 1}) add_to(of_cell[axis], moments(static_cast<Number>(b[axis]), X, Y));
    }
    for (const int axis : {0, 1})
      for (const int i : {0, 1})
        for (const int j : {0, 1}) sums[axis][i][j][lane] = of_cell[axis][i][j];
  }
  return sums;
}
template <class Number, class FluidLaw, class Block>
NoForce body_force_of(const PrintedParticles<FluidLaw, Number>&, const Block&, const Grid&, const NoForce&, double) {
  return {};
}

/// From sums of q, q X, q Y and q XY at least.
template <std::size_t count>
std::array<Lanes, 4> at_corners(const std::array<std::array<Lanes, count>, count>& q) {
  return LinearHat::at_corners(q[0][0], q[1][0], q[0][1], q[1][1]);
}

/// Gives the corners of a part of a block their masses, momenta and forces (12), (13).
template <int part, class FluidLaw, class Mass, class Velocity, class Stress, class BodyForce, class To>
void give(int column, const Mass& m, const Velocity& v, const Stress& stress, const BodyForce& body_force,
          const Vec2& per_cell, To& to) {
  to.template give<mass>(column, at_corners(widened<part>(m)));
  to.template give<momentum_x>(column, at_corners(widened<part>(v[0])));
  to.template give<momentum_y>(column, at_corners(widened<part>(v[1])));
  CornerForces forces = forces_of<FluidLaw>(widened<part>(stress), per_cell);
  if constexpr (is_present<BodyForce>)
    for_indices<2>([&](auto axis) { add_to(forces[axis], at_corners(widened<part>(body_force[axis]))); });
  to.template give<force_x>(column, forces[0]);
  to.template give<force_y>(column, forces[1]);
}

/// Masses, momenta and forces of the nodes; keeps what cells of several particles weigh for `scatter_changes`.
template <class FluidLaw, class Number, class Force>
void scatter(const PrintedParticles<FluidLaw, Number>& particles, const Grid& grid, const Force& force, double time,
             int threads, std::vector<CellMass<Lanes>>& masses, CornerNodes& nodes) {
  constexpr int parts = lanes_of<Number> / lanes;
  masses.resize(particles.order.blocks().size() * parts);
  const Vec2 per_cell = grid.cell.cwiseInverse();
  const auto give_block = [&]<class Block>(int i, const Block& block, auto& to) {
    const auto m = mass_of(particles, block);
    const auto v = momentum_of(particles, block);
    const auto stress = stress_of(particles, block);
    const auto b = body_force_of(particles, block, grid, force, time);
    with_indices<parts>(
        [&](auto... part) { (give<part, FluidLaw>(block.column + part * lanes, m, v, stress, b, per_cell, to), ...); });
    if constexpr (!Block::is_single)
      with_indices<parts>([&](auto... part) { ((masses[i * parts + part] = widened<part>(m)), ...); });
  };
  scatter_rows<mass, force_y>(particles.order, threads, nodes, give_block);
}

/// A field of the nodes within the cells right of and above `node` and those that follow.
inline LinearHat::Within<Lanes> laid_out(const Field<double>& field, int node, int stride) {
  const double* low = &field[node];
  const double* high = low + stride;
  return {load<Lanes>(low), load<Lanes>(low + 1), load<Lanes>(high), load<Lanes>(high + 1)};
}

/// Moments of a field q within the cell.
template <class Within>
Moments<Lanes> moments_of(const Within& q, const CellMass<Lanes>& m) {
  Moments<Lanes> found;
  for_indices<2>([&](auto i) {
    for_indices<2>([&](auto j) {
      found[i][j] = m[i][j] * q.q0 + m[i + 1][j] * q.qX + m[i][j + 1] * q.qY + m[i + 1][j + 1] * q.qXY;
    });
  });
  return found;
}

template <class Real, class Within>
Real at(const Real& X, const Real& Y, const Within& q) {
  return q.q0 + X * q.qX + Y * (q.qY + X * q.qXY);
}

/// Gives the nodes what (16) adds to the momentum of the particles, with which it becomes that of (17):
/// sum_p M_p N_i v_p changes by dt sum_j M_ij a_j with M_ij = sum_p M_p N_i N_j, and each cell knows its part of M_ij.
/// The only particle of a cell gives its own change.
template <class FluidLaw, class Number>
void scatter_changes(const PrintedParticles<FluidLaw, Number>& particles, const std::vector<CellMass<Lanes>>& masses,
                     int threads, CornerNodes& nodes) {
  using Real = LanesOf<Number>;
  constexpr int parts = lanes_of<Number> / lanes;
  const auto give_part = [&]<class Block>(int i, const Block& block, auto part, auto& to) {
    const int column = block.column + part * lanes, node = block.row * nodes.stride + column;
    const auto moments = [&](const auto& q) {
      if constexpr (Block::is_single) {
        const Lanes X = widened<part>(load<Real>(&particles.X[block.first])),
                    Y = widened<part>(load<Real>(&particles.Y[block.first]));
        return mpm::moments(at(X, Y, q), X, Y);
      } else {
        return moments_of(q, masses[i * parts + part]);
      }
    };
    const auto along = [&](const Field<double>& change) {
      return at_corners(moments(laid_out(change, node, nodes.stride)));
    };
    to.template give<momentum_x>(column, along(nodes.change.x));
    to.template give<momentum_y>(column, along(nodes.change.y));
  };
  scatter_rows<momentum_x, momentum_y>(particles.order, threads, nodes, [&](int i, const auto& block, auto& to) {
    with_indices<parts>([&](auto... part) { (give_part(i, block, part, to), ...); });
  });
}

/// The same in the lanes of particles.
template <class Real>
LinearHat::Within<Real> field(const Field<double>& of, int node, int stride) {
  using Within = LinearHat::Within<Lanes>;
  const auto part = [&](Lanes Within::*q) {
    return joined<Real>([&](int lane) { return laid_out(of, node + lane, stride).*q; });
  };
  LinearHat::Within<Real> field;
  field.q0 = part(&Within::q0);
  field.qX = part(&Within::qX);
  field.qY = part(&Within::qY);
  field.qXY = part(&Within::qXY);
  return field;
}

/// Fields of the nodes within a block of cells.
template <class Real>
struct FieldPair {
  LinearHat::Within<Real> x, y;

  FieldPair(const NodeVectors& of, int node, int stride)
      : x(field<Real>(of.x, node, stride)), y(field<Real>(of.y, node, stride)) {}
};

/// Writes every lane.
struct Everywhere {
  template <class Real>
  void operator()(const Real& value, NumberIn<Real>* to) const {
    store(value, to);
  }
  template <class Mask>
  Mask unless_absent(const Mask& mask) const {
    return mask;
  }
};

/// Strain (18), density and stress (19), from the velocity remapped to the nodes; true if the density is plausible.
template <class Real, class Number, class FluidLaw, class Velocity, class Write>
Mask<Real> strain(PrintedParticles<FluidLaw, Number>& particles, int slot, const Velocity& v, const Vec2& per_cell,
                  double dt, const FluidLaw& fluid, const Write& write) {
  const Real X = load<Real>(&particles.X[slot]), Y = load<Real>(&particles.Y[slot]);
  const Real along_x = fill<Real>(per_cell.x()), along_y = fill<Real>(per_cell.y());
  const Slopes<Real> of_v{.xx = along_x * (v.x.qX + Y * v.x.qXY),
                          .yx = along_x * (v.y.qX + Y * v.y.qXY),
                          .xy = along_y * (v.x.qY + X * v.x.qXY),
                          .yy = along_y * (v.y.qY + X * v.y.qXY)};
  const Real before = load<Real>(&particles.expansion[slot]);
  const Real after = before + (1 + before) * (fill<Real>(dt) * of_v.divergence());
  write(after, &particles.expansion[slot]);
  particles.stress.template update<Real>(slot, fluid, after, of_v, write);
  return write.unless_absent(between(1 / most_density, 1 + after, 1 / least_density));
}

/// Sets a particle going, with the stress of its density and its velocity's slopes.
template <class FluidLaw, class Number>
void begin(PrintedParticles<FluidLaw, Number>& particles, int slot, const Beginning& fluid_there, const FluidLaw& fluid,
           const Vec2& /*cell*/, double /*dt*/) {
  using Real = LanesOf<Number>;
  particles.vx[slot] = static_cast<Number>(fluid_there.v.x());
  particles.vy[slot] = static_cast<Number>(fluid_there.v.y());
  particles.expansion[slot] = static_cast<Number>(fluid_there.expansion);
  const Slopes<double>& of = fluid_there.of;
  particles.stress.template update<Real>(slot, fluid, fill<Real>(fluid_there.expansion),
                                         {fill<Real>(of.xx), fill<Real>(of.yx), fill<Real>(of.xy), fill<Real>(of.yy)},
                                         FirstLane{});
}

/// Place (15) and velocity (16); true if the particles are still in their cells.
template <class Real, class Number, class FluidLaw, class Vectors, class Write>
Mask<Real> move(PrintedParticles<FluidLaw, Number>& particles, int slot, const Vectors& displacement,
                const Vectors& change, const Write& write) {
  const Real X = load<Real>(&particles.X[slot]), Y = load<Real>(&particles.Y[slot]);
  write(load<Real>(&particles.vx[slot]) + at(X, Y, change.x), &particles.vx[slot]);
  write(load<Real>(&particles.vy[slot]) + at(X, Y, change.y), &particles.vy[slot]);
  const Real new_X = X + at(X, Y, displacement.x), new_Y = Y + at(X, Y, displacement.y);
  write(new_X, &particles.X[slot]);
  write(new_Y, &particles.Y[slot]);
  return write.unless_absent(between(0, new_X, 1) & between(0, new_Y, 1));
}

/// Calls body(slot, write) for all particles of a block, one of each cell at a time. Returns a bit for each cell, set
/// if body was true for all its particles.
template <class Real, class Block, class Body>
LaneBits for_all(const Block& block, const Body& body) {
  constexpr int width = lanes_of<NumberIn<Real>>;
  Mask<Real> each = Real{} == Real{};
  for (int k = 0; k < block.least(); ++k) each &= body(block.first + k * width, Everywhere{});
  const Real count = converted<Real>(block.count.data());
  for (int k = block.least(); k < block.most(); ++k)
    each &= body(block.first + k * width, IfPresent<Real>{fill<Real>(k) < count});
  return lanes_with<Real>(each);
}

/// Grid to particles. A bit of `calm` is set for each cell whose particles are all still in it, with plausible
/// densities; one that is not a number is not.
template <class FluidLaw, class Number>
void gather(const CornerNodes& nodes, const Grid& grid, const FluidLaw& law, double dt, int threads,
            PrintedParticles<FluidLaw, Number>& particles, std::vector<LaneBits>& calm) {
  using Real = LanesOf<Number>;
  using Fields = FieldPair<Real>;
  calm.resize(particles.order.blocks().size());
  const auto gather_row = [&](int begin, int end, const auto& block_at) __attribute__((flatten, noinline)) {
    const FluidLaw fluid = law;  // a copy, known not to change while particles are written
    const Vec2 per_cell = grid.cell.cwiseInverse();
    for (int i = begin; i < end; ++i) {
      const auto& block = block_at(i);
      const auto fields = [&, node = block.row * nodes.stride + block.column](const NodeVectors& of) {
        return Fields(of, node, nodes.stride);
      };
      if constexpr (std::remove_cvref_t<decltype(block)>::is_single) {
        // Each field is laid out where it is needed: all three are more than the registers hold.
        const auto dense =
            strain<Real>(particles, block.first, fields(nodes.velocity), per_cell, dt, fluid, Everywhere{});
        calm[i] = lanes_with<Real>(
            dense & move<Real>(particles, block.first, fields(nodes.displacement), fields(nodes.change), Everywhere{}));
      } else {
        const Fields v = fields(nodes.velocity), displacement = fields(nodes.displacement),
                     change = fields(nodes.change);
        calm[i] = for_all<Real>(block, [&](int slot, const auto& write) {
          const auto dense = strain<Real>(particles, slot, v, per_cell, dt, fluid, write);
          return dense & move<Real>(particles, slot, displacement, change, write);
        });
      }
    }
  };
  for_rows(particles.order, threads, gather_row);
}

}  // namespace touchstone::mpm
