#pragma once
/// What transfers do in cells: what particles give, how they take their velocities, and how these come to the nodes
/// anew.

#include "solvers/mpm/printed/transfer.hpp"
#include "solvers/mpm/splines/particles.hpp"
#include "solvers/mpm/splines/walls.hpp"
#include "solvers/mpm/splines/within.hpp"
#include "solvers/stepping/clock.hpp"

namespace touchstone::mpm {

/// What cells give to their nodes in the first scatter: mass, then momenta and impulses of both axes.
enum GivenToSplines { mass_given, momentum_given, impulse_given = 3 };

/// Calls work(axis) for both axes.
template <class Work>
void for_axes(const Work& work) {
  for_indices<2>(work);
}
template <int axis, class Particles>
auto& component(Particles& particles) {
  if constexpr (axis == 0)
    return particles.x;
  else
    return particles.y;
}
template <int axis>
const Field<double>& component(const NodeVectors& of) {
  return axis == 0 ? of.x : of.y;
}

/// What the stress gives the nodes in a step (12), of the force along `axis` what acts along another.
template <int axis, int along, class FluidLaw>
auto stress_turn(const Stress<FluidLaw, double>& stress, int slot, const Place& at, const Vec2& dt_per_cell) {
  if constexpr (axis == along || Viscous<FluidLaw>)
    return flux_turn(at, -dt_per_cell[along] * stress.template of<Lanes>(axis, along, slot));
  else
    return NoTurn{};
}

/// Calls work(slot, X, Y) for all particles of a block; slots without one, at X = Y = 0, have nothing to add to a sum.
template <class Particles, class Block, class Work>
void for_places(const Particles& particles, const Block& block, const Work& work) {
  const int end = block.slot(0, block.most());
  for (int slot = block.first; slot < end; slot += lanes)
    work(slot, Place(load<Lanes>(&particles.X[slot])), Place(load<Lanes>(&particles.Y[slot])));
}

/// Sums over the particles of a block of X^m Y^n with m, n < count.
template <int count, class Particles, class Block>
auto moments_of(const Particles& particles, const Block& block) {
  return sums_of_powers<0, count, [](int) { return count; }>(particles, block, one_each);
}

/// Where the gather has taken all velocities.
struct NothingToTake {
  NothingToTake(const auto& /*transfer*/, const SplineNodes&, int /*node*/) {}
  template <class Particles, class Write>
  void take(Particles&, int, const Place&, const Place&, const Write&) const {}
};

template <class Transfer>
class InCells;

/// Momentum and impulse are one: what particles had before does not matter.
template <>
class InCells<Apic> {
 public:
  static constexpr int given = 3;

  InCells(const SplineNodes&) {}

  static void make_room(std::size_t /*blocks*/) {}

  /// A change of velocity [m/s] that a force gives a particle before it gives to the nodes.
  template <class Particles>
  static void push(Particles& particles, int slot, const Vec2& dv) {
    particles.x.v[slot] += dv.x();
    particles.y.v[slot] += dv.y();
  }

  template <bool /*pushed*/, class Particles, class Block>
  void give(const Particles& particles, int /*index*/, const Block& block, const Grid& grid, const Vec2& dt_per_cell,
            GivenToCentres<given>& to) {
    to.give(mass_given, block.column, nodes_of(moments_of<3>(particles, block)));
    with_splines(grid, block, [&](const auto& splines_x, const auto& splines_y) {
      for_axes([&](auto axis) {
        const auto& of = component<axis>(particles);
        PowersOfBoth sums{};
        for_places(particles, block, [&](int slot, const Place& X, const Place& Y) {
          add(sums, X, Y, load<Lanes>(&of.v[slot]),
              affine_turn(splines_x, X, load<Lanes>(&of.along_x[slot])) +
                  stress_turn<axis, 0>(particles.stress, slot, X, dt_per_cell),
              affine_turn(splines_y, Y, load<Lanes>(&of.along_y[slot])) +
                  stress_turn<axis, 1>(particles.stress, slot, Y, dt_per_cell));
        });
        to.give(momentum_given + axis, block.column, nodes_of(sums));
      });
    });
  }

  /// v_i = (m v)_i / m_i, held at walls.
  static void accelerate(SplineNodes& nodes, const SplineWalls& walls, const Vec2& push, const Clock& clock,
                         int threads) {
    nodes.find_mean(momentum_given, nodes.velocity, threads);
    nodes.push(push, nodes.velocity, threads);
    walls.hold(nodes, clock.time() + clock.time_step(), nodes.velocity);
    nodes.edges.unfold(nodes.velocity);
  }

  /// v_p = sum w_ip v_i, C_p = sum v_i (w_ip (x_i - x_p) / D)^T, and what particles give of these.
  template <class Particles>
  static void gather(SplineNodes& nodes, const Grid& grid, int threads, Particles& particles) {
    const auto gather_block = [&](int, const auto& block, auto& to) __attribute__((flatten)) {
      const int node = nodes.stride * block.row + block.column;
      with_splines(grid, block, [&](const auto& splines_x, const auto& splines_y) {
        for_axes([&](auto axis) {
          auto& of = component<axis>(particles);
          const PowersOfBoth velocity = laid_out(nodes, component<axis>(nodes.velocity), node);
          PowersOfBoth sums{};
          for_particles_of(block, [&](int slot, const auto& write) {
            const Place X(load<Lanes>(&particles.X[slot])), Y(load<Lanes>(&particles.Y[slot]));
            const Seen found = seen(velocity, X, Y, splines_x.affine_slope(X), splines_y.affine_slope(Y));
            add(sums, X, Y, write(found.value, &of.v[slot]),
                affine_turn(splines_x, X, write(found.along_x, &of.along_x[slot])),
                affine_turn(splines_y, Y, write(found.along_y, &of.along_y[slot])));
          });
          to.give(axis, block.column, nodes_of(sums));
        });
      });
    };
    give_by_rows<2>(particles.order, threads, nodes, gather_block);
    nodes.find_mean(0, nodes.strained, threads);
  }

  using Taken = NothingToTake;
};

/// For transfers in which particles take from the nodes by how these change.
class MomentumAndImpulseApart {
 public:
  static constexpr int given = 5;

  template <class Particles>
  static void push(Particles& particles, int slot, const Vec2& dv) {
    particles.x.place[slot] = dv.x();
    particles.y.place[slot] = dv.y();
  }

  /// v_i and dv_i, held at walls.
  static void accelerate(SplineNodes& nodes, const SplineWalls& walls, const Vec2& push, const Clock& clock,
                         int threads) {
    nodes.find_mean(momentum_given, nodes.start, threads);
    nodes.find_mean(impulse_given, nodes.velocity, threads);
    nodes.add_up(nodes.start, 1, nodes.velocity, nodes.velocity, threads);
    nodes.push(push, nodes.velocity, threads);
    walls.hold_motion(nodes, clock.time(), clock.time_step(), clock.steps() == 0);
    nodes.edges.unfold(nodes.start);
    nodes.edges.unfold(nodes.velocity);
  }

 protected:
  template <bool pushed, class Particles, class Block>
  static void give_motion(const Particles& particles, const Block& block, const Vec2& dt_per_cell,
                          GivenToCentres<given>& to) {
    for_axes([&](auto axis) {
      const auto& of = component<axis>(particles);
      PowersOfBoth momentum{}, impulse{};
      for_places(particles, block, [&](int slot, const Place& X, const Place& Y) {
        add(momentum, X, Y, load<Lanes>(&of.v[slot]));
        if constexpr (pushed) add(impulse, X, Y, load<Lanes>(&of.place[slot]));
        add_along_x(impulse, stress_turn<axis, 0>(particles.stress, slot, X, dt_per_cell), Y);
        add_along_y(impulse, X, stress_turn<axis, 1>(particles.stress, slot, Y, dt_per_cell));
      });
      to.give(momentum_given + axis, block.column, nodes_of(momentum));
      to.give(impulse_given + axis, block.column, nodes_of(impulse));
    });
  }
};

/// Particles keep their velocities, take what the nodes change, and move with these.
template <>
class InCells<Flip> : public MomentumAndImpulseApart {
 public:
  InCells(const SplineNodes&) {}

  static void make_room(std::size_t /*blocks*/) {}

  template <bool pushed, class Particles, class Block>
  void give(const Particles& particles, int /*index*/, const Block& block, const Grid&, const Vec2& dt_per_cell,
            GivenToCentres<given>& to) {
    to.give(mass_given, block.column, nodes_of(moments_of<3>(particles, block)));
    give_motion<pushed>(particles, block, dt_per_cell, to);
  }

  /// v_p += sum w_ip dv_i, and what particles give of it.
  template <class Particles>
  static void gather(SplineNodes& nodes, const Grid&, int threads, Particles& particles) {
    NodeVectors& change = nodes.start;
    nodes.add_up(nodes.velocity, -1, nodes.start, change, threads);
    const auto gather_block = [&](int, const auto& block, auto& to) __attribute__((flatten)) {
      const int node = nodes.stride * block.row + block.column;
      for_axes([&](auto axis) {
        auto& of = component<axis>(particles);
        const PowersOfBoth velocity = laid_out(nodes, component<axis>(nodes.velocity), node),
                           change_within = laid_out(nodes, component<axis>(change), node);
        PowersOfBoth sums{};
        for_particles_of(block, [&](int slot, const auto& write) {
          const Place X(load<Lanes>(&particles.X[slot])), Y(load<Lanes>(&particles.Y[slot]));
          write(value_at(velocity, X, Y), &of.place[slot]);
          add(sums, X, Y, write(load<Lanes>(&of.v[slot]) + value_at(change_within, X, Y), &of.v[slot]));
        });
        to.give(axis, block.column, nodes_of(sums));
      });
    };
    give_by_rows<2>(particles.order, threads, nodes, gather_block);
    nodes.find_mean(0, nodes.strained, threads);
  }

  using Taken = NothingToTake;
};

/// Nodes to particles and back again is, within each cell, a matrix of moments of its particles: no particle is looked
/// at until all terms are summed.
template <int m>
class InCells<Xpic<m>> : public MomentumAndImpulseApart {
 public:
  InCells(const SplineNodes& nodes) : taken_(nodes.places()) {}

  void make_room(std::size_t blocks) { moments_.resize(blocks); }

  template <bool pushed, class Particles, class Block>
  void give(const Particles& particles, int index, const Block& block, const Grid&, const Vec2& dt_per_cell,
            GivenToCentres<given>& to) {
    moments_[index] = moments_of<5>(particles, block);
    PowersOfBoth mass;
    for_three([&](auto i) { for_three([&](auto k) { mass[i][k] = moments_[index][i][k]; }); });
    to.give(mass_given, block.column, nodes_of(mass));
    give_motion<pushed>(particles, block, dt_per_cell, to);
  }

  template <class Particles>
  void gather(SplineNodes& nodes, const Grid&, int threads, Particles& particles) {
    NodeVectors& smoothed = nodes.start;
    nodes.add_up(nodes.velocity, m - 1, smoothed, taken_, threads);
    double binomial = m;  // m over k, with the sign of the term
    for (int k = 2; k <= m; ++k) {
      there_and_back(particles.order, smoothed, smoothed, nodes, threads);
      nodes.edges.unfold(smoothed);
      binomial *= -static_cast<double>(m - k + 1) / k;
      nodes.add_up(taken_, binomial, smoothed, taken_, threads);
    }
    there_and_back(particles.order, taken_, nodes.strained, nodes, threads);
  }

  struct Taken {
    PowersOfBoth vx, vy, place_x, place_y;

    Taken(const InCells& transfer, const SplineNodes& nodes, int node)
        : vx(laid_out(nodes, transfer.taken_.x, node)),
          vy(laid_out(nodes, transfer.taken_.y, node)),
          place_x(laid_out(nodes, nodes.velocity.x, node)),
          place_y(laid_out(nodes, nodes.velocity.y, node)) {}
    template <class Particles, class Write>
    void take(Particles& particles, int slot, const Place& X, const Place& Y, const Write& write) const {
      write(value_at(vx, X, Y), &particles.x.v[slot]);
      write(value_at(vy, X, Y), &particles.y.v[slot]);
      write(value_at(place_x, X, Y), &particles.x.place[slot]);
      write(value_at(place_y, X, Y), &particles.y.place[slot]);
    }
  };

 private:
  using Moments = std::array<std::array<Lanes, 5>, 5>;

  /// Sums over the particles of q X^i Y^k, for a field q.
  static PowersOfBoth sums_of(const PowersOfBoth& q, const Moments& moments) {
    PowersOfBoth sums{};
    for_three([&](auto i) {
      for_three([&](auto k) {
        for_three([&](auto a) { for_three([&](auto b) { sums[i][k] += moments[i + a][k + b] * q[a][b]; }); });
      });
    });
    return sums;
  }

  /// What nodes get from particles that took `from` from them.
  template <int width>
  void there_and_back(const CellOrder<width>& order, const NodeVectors& from, NodeVectors& to_field, SplineNodes& nodes,
                      int threads) const {
    const auto give_block = [&](int index, const auto& block, auto& to) __attribute__((flatten)) {
      const int node = nodes.stride * block.row + block.column;
      for_axes([&](auto axis) {
        to.give(axis, block.column, nodes_of(sums_of(laid_out(nodes, component<axis>(from), node), moments_[index])));
      });
    };
    give_by_rows<2>(order, threads, nodes, give_block);
    nodes.find_mean(0, to_field, threads);
  }

  NodeVectors taken_;             // m/s
  std::vector<Moments> moments_;  // of each block
};

}  // namespace touchstone::mpm
