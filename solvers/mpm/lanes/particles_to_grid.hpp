#pragma once
/// What transfers do in lanes: what particles give, how they take their velocities, and how these come to the nodes
/// anew.

#include "solvers/mpm/lanes/particles.hpp"
#include "solvers/mpm/lanes/grid_walls.hpp"
#include "solvers/stepping/clock.hpp"

namespace touchstone::mpm {

/// What cells give to their nodes in the first scatter: mass, then momenta and impulses of both axes.
enum GivenInLanes { mass_given, momentum_given, impulse_given = 3 };

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

/// What the stress gives the nodes in a step (12): its component on `axis` that acts along `along`.
template <int axis, int along, class FluidLaw, class At>
auto stress_turn(const Stress<FluidLaw, double>& stress, int slot, const At& at, const Vec2& dt_per_cell) {
  if constexpr (axis == along || Viscous<FluidLaw>)
    return flux_extra(at, -dt_per_cell[along] * stress.template of<Lanes>(axis, along, slot));
  else
    return NoExtra{};
}

template <int axis, int along, class At>
NoExtra stress_turn(const NoStress&, int /*slot*/, const At&, const Vec2& /*dt_per_cell*/) {
  return {};
}

/// Calls work(slot, X, Y) for all particles of a block; slots without one, at X = Y = 0, have nothing to add to a sum.
template <class AlongX, class AlongY, class Particles, class Block, class Work>
void for_places(const AlongX& along_x, const AlongY& along_y, const Particles& particles, const Block& block,
                const Work& work) {
  const int end = block.slot(0, block.most());
  for (int slot = block.first; slot < end; slot += lanes)
    work(slot, along_x.at(load<Lanes>(&particles.X[slot])), along_y.at(load<Lanes>(&particles.Y[slot])));
}

/// For transfers whose particles have taken their velocities in the gather.
struct NothingToTake {
  NothingToTake(const auto& /*transfer*/, const auto& /*nodes*/, int /*node*/) {}
  template <class Particles, class At, class Write>
  void take(Particles&, int, const At&, const At&, const Write&) const {}
};

/// `Shape` is in lanes.
template <class Transfer, class Shape>
class TransferInLanes;

/// Momentum and impulse are one: what particles had before does not matter.
template <class Shape>
class TransferInLanes<Apic, Shape> {
  using Nodes = LaneNodes<Shape>;
  using Sums = typename Shape::Sums;

 public:
  static constexpr int given = 3;
  static constexpr bool remaps = true;

  explicit TransferInLanes(const Nodes&) {}

  static void make_room(std::size_t /*blocks*/) {}

  /// A change of velocity [m/s] that a force gives a particle before it gives to the nodes.
  template <class Particles>
  static void push(Particles& particles, int slot, const Vec2& dv) {
    particles.x.v[slot] += dv.x();
    particles.y.v[slot] += dv.y();
  }

  template <bool /*pushed*/, class Particles, class Block, class To>
  void give(const Particles& particles, int /*index*/, const Block& block, const Shape& shape, const Vec2& dt_per_cell,
            To& to) {
    to.give(mass_given, block.column, nodes_of(shape.mass(particles, block)));
    shape.with_affine(block, [&](const auto& along_x, const auto& along_y) {
      for_axes([&](auto axis) {
        const auto& of = component<axis>(particles);
        Sums sums{};
        for_places(along_x, along_y, particles, block, [&](int slot, const auto& X, const auto& Y) {
          add(sums, X, Y, load<Lanes>(&of.v[slot]),
              affine_extra(along_x, X, load<Lanes>(&of.along_x[slot])) +
                  stress_turn<axis, 0>(particles.stress, slot, X, dt_per_cell),
              affine_extra(along_y, Y, load<Lanes>(&of.along_y[slot])) +
                  stress_turn<axis, 1>(particles.stress, slot, Y, dt_per_cell));
        });
        to.give(momentum_given + axis, block.column, nodes_of(sums));
      });
    });
  }

  /// v_i = (m v)_i / m_i, held at walls.
  template <class Walls>
  static void accelerate(Nodes& nodes, const Walls& walls, const Vec2& push, const Clock& clock, int threads) {
    nodes.find_mean(momentum_given, nodes.velocity, threads);
    nodes.push(push, nodes.velocity, threads);
    walls.hold(nodes, clock.time() + clock.time_step(), nodes.velocity);
    nodes.edges.unfold(nodes.velocity);
  }

  /// v_p = sum w_ip v_i, C_p = sum v_i (w_ip (x_i - x_p) / D)^T, and what particles give of these.
  template <class Particles>
  static void gather(Nodes& nodes, const Shape& shape, int threads, Particles& particles) {
    const auto gather_block = [&](int, const auto& block, auto& to) __attribute__((flatten)) {
      const int node = nodes.stride * block.row + block.column;
      shape.with_affine(block, [&](const auto& along_x, const auto& along_y) {
        for_axes([&](auto axis) {
          auto& of = component<axis>(particles);
          const Sums velocity = Shape::within(nodes, component<axis>(nodes.velocity), node);
          Sums sums{};
          for_particles_of(block, [&](int slot, const auto& write) {
            const auto X = along_x.at(load<Lanes>(&particles.X[slot])), Y = along_y.at(load<Lanes>(&particles.Y[slot]));
            const ValueAndSlopes found =
                value_and_slopes(velocity, X, Y, along_x.affine_slope(X), along_y.affine_slope(Y));
            add(sums, X, Y, write(found.value, &of.v[slot]),
                affine_extra(along_x, X, write(found.along_x, &of.along_x[slot])),
                affine_extra(along_y, Y, write(found.along_y, &of.along_y[slot])));
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

/// Momentum, impulse and stress are one, and taken in one pass (`GatherInLanes`).
template <class Shape>
class TransferInLanes<MlsApic, Shape> : public TransferInLanes<Apic, Shape> {
 public:
  static constexpr bool remaps = false;
  using TransferInLanes<Apic, Shape>::TransferInLanes;
};

/// For transfers in which particles take from the nodes by how these change.
template <class Shape>
class MomentumAndImpulseApart {
 protected:
  using Nodes = LaneNodes<Shape>;
  using Sums = typename Shape::Sums;

 public:
  static constexpr int given = 5;
  static constexpr bool remaps = true;

  explicit MomentumAndImpulseApart(Nodes& nodes) { nodes.start = NodeVectors(nodes.places()); }

  template <class Particles>
  static void push(Particles& particles, int slot, const Vec2& dv) {
    particles.x.place[slot] = dv.x();
    particles.y.place[slot] = dv.y();
  }

  /// v_i and dv_i, held at walls.
  template <class Walls>
  static void accelerate(Nodes& nodes, const Walls& walls, const Vec2& push, const Clock& clock, int threads) {
    nodes.find_mean(momentum_given, nodes.start, threads);
    nodes.find_mean(impulse_given, nodes.velocity, threads);
    nodes.add_up(nodes.start, 1, nodes.velocity, nodes.velocity, threads);
    nodes.push(push, nodes.velocity, threads);
    walls.hold_motion(nodes, clock.time(), clock.time_step(), clock.steps() == 0);
    nodes.edges.unfold(nodes.start);
    nodes.edges.unfold(nodes.velocity);
  }

 protected:
  template <bool pushed, class Particles, class Block, class To>
  static void give_motion(const Particles& particles, const Block& block, const Shape& shape, const Vec2& dt_per_cell,
                          To& to) {
    shape.with(block, [&](const auto& along_x, const auto& along_y) {
      for_axes([&](auto axis) {
        const auto& of = component<axis>(particles);
        Sums momentum{}, impulse{};
        for_places(along_x, along_y, particles, block, [&](int slot, const auto& X, const auto& Y) {
          add(momentum, X, Y, load<Lanes>(&of.v[slot]));
          if constexpr (pushed) add(impulse, X, Y, load<Lanes>(&of.place[slot]));
          add_along_x(impulse, stress_turn<axis, 0>(particles.stress, slot, X, dt_per_cell), Y);
          add_along_y(impulse, X, stress_turn<axis, 1>(particles.stress, slot, Y, dt_per_cell));
        });
        to.give(momentum_given + axis, block.column, nodes_of(momentum));
        to.give(impulse_given + axis, block.column, nodes_of(impulse));
      });
    });
  }
};

/// Particles keep their velocities, take what the nodes change, and move with these.
template <class Shape>
class TransferInLanes<Flip, Shape> : public MomentumAndImpulseApart<Shape> {
  using Base = MomentumAndImpulseApart<Shape>;
  using typename Base::Nodes, typename Base::Sums;

 public:
  using Base::given;

  using Base::Base;

  static void make_room(std::size_t /*blocks*/) {}

  template <bool pushed, class Particles, class Block, class To>
  void give(const Particles& particles, int /*index*/, const Block& block, const Shape& shape, const Vec2& dt_per_cell,
            To& to) {
    to.give(mass_given, block.column, nodes_of(shape.mass(particles, block)));
    Base::template give_motion<pushed>(particles, block, shape, dt_per_cell, to);
  }

  /// v_p += sum w_ip dv_i, and what particles give of it.
  template <class Particles>
  static void gather(Nodes& nodes, const Shape& shape, int threads, Particles& particles) {
    NodeVectors& change = nodes.start;
    nodes.add_up(nodes.velocity, -1, nodes.start, change, threads);
    const auto gather_block = [&](int, const auto& block, auto& to) __attribute__((flatten)) {
      const int node = nodes.stride * block.row + block.column;
      shape.with(block, [&](const auto& along_x, const auto& along_y) {
        for_axes([&](auto axis) {
          auto& of = component<axis>(particles);
          const Sums velocity = Shape::within(nodes, component<axis>(nodes.velocity), node),
                     change_within = Shape::within(nodes, component<axis>(change), node);
          Sums sums{};
          for_particles_of(block, [&](int slot, const auto& write) {
            const auto X = along_x.at(load<Lanes>(&particles.X[slot])), Y = along_y.at(load<Lanes>(&particles.Y[slot]));
            write(value_at(velocity, X, Y), &of.place[slot]);
            add(sums, X, Y, write(load<Lanes>(&of.v[slot]) + value_at(change_within, X, Y), &of.v[slot]));
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

/// Particles take no velocity until all terms are summed on the nodes.
template <int m, class Shape>
class TransferInLanes<Xpic<m>, Shape> : public MomentumAndImpulseApart<Shape> {
  using Base = MomentumAndImpulseApart<Shape>;
  using typename Base::Nodes, typename Base::Sums;

 public:
  using Base::given;

  explicit TransferInLanes(Nodes& nodes) : Base(nodes), taken_(nodes.places()) {}

  void make_room(std::size_t blocks) { moments_.resize(blocks); }

  template <bool pushed, class Particles, class Block, class To>
  void give(const Particles& particles, int index, const Block& block, const Shape& shape, const Vec2& dt_per_cell,
            To& to) {
    moments_[index] = shape.moments(particles, block);
    to.give(mass_given, block.column, nodes_of(shape.mass(moments_[index], particles, block)));
    Base::template give_motion<pushed>(particles, block, shape, dt_per_cell, to);
  }

  template <class Particles>
  void gather(Nodes& nodes, const Shape& shape, int threads, Particles& particles) {
    NodeVectors& smoothed = nodes.start;
    nodes.add_up(nodes.velocity, m - 1, smoothed, taken_, threads);
    double binomial = m;  // m over k, with the sign of the term
    for (int k = 2; k <= m; ++k) {
      there_and_back(particles, shape, smoothed, smoothed, nodes, threads);
      nodes.edges.unfold(smoothed);
      binomial *= -static_cast<double>(m - k + 1) / k;
      nodes.add_up(taken_, binomial, smoothed, taken_, threads);
    }
    there_and_back(particles, shape, taken_, nodes.strained, nodes, threads);
  }

  struct Taken {
    Sums vx, vy, place_x, place_y;

    Taken(const TransferInLanes& transfer, const Nodes& nodes, int node)
        : vx(Shape::within(nodes, transfer.taken_.x, node)),
          vy(Shape::within(nodes, transfer.taken_.y, node)),
          place_x(Shape::within(nodes, nodes.velocity.x, node)),
          place_y(Shape::within(nodes, nodes.velocity.y, node)) {}
    template <class Particles, class At, class Write>
    void take(Particles& particles, int slot, const At& X, const At& Y, const Write& write) const {
      write(value_at(vx, X, Y), &particles.x.v[slot]);
      write(value_at(vy, X, Y), &particles.y.v[slot]);
      write(value_at(place_x, X, Y), &particles.x.place[slot]);
      write(value_at(place_y, X, Y), &particles.y.place[slot]);
    }
  };

 private:
  /// What nodes get from particles that took `from` from them.
  template <class Particles>
  void there_and_back(const Particles& particles, const Shape& shape, const NodeVectors& from, NodeVectors& to_field,
                      Nodes& nodes, int threads) const {
    const auto give_block = [&](int index, const auto& block, auto& to) __attribute__((flatten)) {
      const int node = nodes.stride * block.row + block.column;
      for_axes([&](auto axis) {
        to.give(axis, block.column,
                nodes_of(shape.there_and_back(Shape::within(nodes, component<axis>(from), node), moments_[index],
                                              particles, block)));
      });
    };
    give_by_rows<2>(particles.order, threads, nodes, give_block);
    nodes.find_mean(0, to_field, threads);
  }

  NodeVectors taken_;                             // m/s
  std::vector<typename Shape::Moments> moments_;  // of each block
};

}  // namespace touchstone::mpm
