#pragma once
/// The nodes of methods in lanes, and where these are the same, or splines are cut off, at edges.

#include "solvers/mpm/lanes/shape_functions.hpp"
#include "solvers/mpm/printed/nodes.hpp"

namespace touchstone::mpm {

/// A line of ghosts, each of a node in the fluid.
struct GhostLine {
  int axis;                   // 0: a column of nodes, 1: a row
  int at, inner;              // of the ghosts, and of the nodes in the fluid
  std::vector<int> ghosts{};  // those near particles
  int step = 0;               // from a ghost to its node in the fluid

  template <int touched>
  void list_near(const NodesOfCells<touched>& nodes) {
    ghosts.clear();
    step = (inner - at) * (axis == 0 ? 1 : nodes.stride);
    nodes.for_near_on(axis, at, [&](int ghost) { ghosts.push_back(ghost); });
  }
};

/// Where nodes are not all alike. Along a periodic axis the first nodes and the last are the same: of two, one is a
/// ghost of the other. Quadratic B-splines give to nodes, and are seen, as if splines were whole and went on past the
/// edges of the domain; at an edge that is not periodic they are cut off, as `BSpline` has them, with a node on the
/// edge in place of the ghost: a field that is v there and u at the first node within is 2 v - u at the ghost, so what
/// the ghost is given belongs twice to the node on the edge, and is taken from the first within.
template <class Shape>
class Edges {
  static constexpr int touched = Shape::touched;

 public:
  explicit Edges(const Grid& grid) {
    const auto add = [&](int axis, int cells, bool periodic) {
      constexpr int first = Shape::first_of_period;
      if (periodic)
        for (int k = 0; k < touched - 1; ++k)
          k < first ? lines_.push_back({{axis, k, k + cells}, true})
                    : lines_.push_back({{axis, k + cells, first + (k - first) % cells}, true});
      else if (Shape::cut_at_edges) {
        lines_.push_back({{axis, 0, 1}, false});
        lines_.push_back({{axis, cells + 1, cells}, false});
      }
    };
    add(0, grid.columns, grid.periodic_x);
    add(1, grid.rows, grid.periodic_y);
  }

  void list_near(const NodesOfCells<touched>& nodes) {
    for (EdgeLine& line : lines_) line.list_near(nodes);
  }

  /// Takes what the ghosts were given to the nodes.
  void fold(Field<double>& given) const {
    for (const EdgeLine& line : lines_)
      for (int ghost : line.ghosts) {
        const double g = given[ghost];
        given[ghost + line.step] += line.periodic ? g : -g;
        given[ghost] = line.periodic ? 0 : 2 * g;
      }
  }
  /// Makes of a field of the nodes one that cells see.
  void unfold(Field<double>& field) const {
    for (const EdgeLine& line : lines_)
      for (int ghost : line.ghosts) {
        const double inner = field[ghost + line.step];
        field[ghost] = line.periodic ? inner : 2 * field[ghost] - inner;
      }
  }
  void unfold(NodeVectors& field) const {
    unfold(field.x);
    unfold(field.y);
  }

 private:
  struct EdgeLine : GhostLine {
    bool periodic;
  };
  std::vector<EdgeLine> lines_;
};

/// What the nodes hold within a step; parts of a method make room for what they need. A node that is left out has no
/// mass, and no velocity.
template <class Shape>
class LaneNodes : public NodesOfCells<Shape::touched> {
  using Base = NodesOfCells<Shape::touched>;

 public:
  using Base::near, Base::places;

  LaneNodes(const Grid& grid, int block_width)
      : Base(grid, block_width), per_mass(places()), velocity(places()), edges(grid) {}

  Field<double> per_mass;  // 1/particles
  NodeVectors velocity;    // m/s  with which the nodes move
  // Of those methods that need it:
  NodeVectors start{0};     // m/s  that particles gave
  NodeVectors strained{0};  // m/s  by which the fluid is strained: particles gave it anew
  Field<double> expansion;  // -    that particles gave
  Edges<Shape> edges;

  template <int width>
  void list_near(const CellOrder<width>& order) {
    Base::list_near(order);
    edges.list_near(*this);
  }
  bool moves(int node) const { return per_mass[node] > 0; }
  /// Adds a mass [particles] that moves at v [m/s] to a node.
  void join(int node, double mass, const Vec2& v, NodeVectors& velocity_of) {
    const double before = moves(node) ? 1 / per_mass[node] : 0;
    per_mass[node] = 1 / (before + mass);
    velocity_of.set(node, per_mass[node] * (before * velocity_of[node] + mass * v));
  }

  void find_mass(int threads) {
    collect(0, per_mass, threads);
    for_near(near(), threads, [&](int node) {
      const Lanes m = load<Lanes>(&per_mass[node]);
      const auto moves = m > fill<Lanes>(CornerNodes::least_mass);
      store(moves ? 1 / (moves ? m : fill<Lanes>(1)) : Lanes{}, &per_mass[node]);
    });
  }
  /// The mean of what the nodes were given.
  void find_mean(int field, Field<double>& mean, int threads) {
    collect(field, mean, threads);
    for_near(near(), threads,
             [&](int node) { store(load<Lanes>(&per_mass[node]) * load<Lanes>(&mean[node]), &mean[node]); });
  }
  void find_mean(int field_of_x, NodeVectors& mean, int threads) {
    find_mean(field_of_x, mean.x, threads);
    find_mean(field_of_x + 1, mean.y, threads);
  }
  /// One field and so many times another.
  void add_up(const NodeVectors& one, double times, const NodeVectors& other, NodeVectors& sum, int threads) const {
    for_near(near(), threads, [&](int node) {
      store(load<Lanes>(&one.x[node]) + times * load<Lanes>(&other.x[node]), &sum.x[node]);
      store(load<Lanes>(&one.y[node]) + times * load<Lanes>(&other.y[node]), &sum.y[node]);
    });
  }
  void bound_expansion(double most_expansion, int threads) {
    const Lanes most = fill<Lanes>(most_expansion);
    for_near(near(), threads, [&](int node) {
      const Lanes e = load<Lanes>(&expansion[node]);
      store(e > most ? most : e, &expansion[node]);
    });
  }
  /// Adds the same to all nodes that move.
  void push(const Vec2& dv, NodeVectors& velocity_of, int threads) const {
    for_near(near(), threads, [&](int node) {
      const auto moves = load<Lanes>(&per_mass[node]) > Lanes{};
      store(load<Lanes>(&velocity_of.x[node]) + (moves ? fill<Lanes>(dv.x()) : Lanes{}), &velocity_of.x[node]);
      store(load<Lanes>(&velocity_of.y[node]) + (moves ? fill<Lanes>(dv.y()) : Lanes{}), &velocity_of.y[node]);
    });
  }

 private:
  void collect(int field, Field<double>& sum, int threads) {
    for_near(near(), threads, [&](int node) { store(this->given(field, node), &sum[node]); });
    edges.fold(sum);
  }
};

}  // namespace touchstone::mpm
