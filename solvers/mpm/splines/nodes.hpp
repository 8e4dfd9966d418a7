#pragma once
/// The nodes of the method with quadratic B-splines, where splines are cut off, repeated or held at edges.

#include "solvers/mpm/centre_nodes.hpp"
#include "solvers/mpm/printed/nodes.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"

namespace touchstone::mpm {

/// Where the splines of cells are not all alike. Cells give to, and see, nodes as if splines were whole and went on
/// past the edges of the domain. At a periodic boundary the ghost behind it is a node on the other side. At another
/// edge splines are cut off, as `BSpline` has them, with a node on the edge in place of the ghost: a field that is v
/// there and u at the first node within is 2 v - u at the ghost, so what the ghost is given belongs twice to the node
/// on the edge, and is taken from the first within.
class Edges {
 public:
  explicit Edges(const Grid& grid) {
    const auto add = [&](int axis, int cells, bool periodic) {
      lines_.push_back({axis, periodic, 0, periodic ? cells : 1});
      lines_.push_back({axis, periodic, cells + 1, periodic ? 1 : cells});
    };
    add(0, grid.columns, grid.periodic_x);
    add(1, grid.rows, grid.periodic_y);
  }

  void list_near(const CentreNodes& nodes) {
    for (Line& line : lines_) {
      line.ghosts.clear();
      line.step = (line.inner - line.at) * (line.axis == 0 ? 1 : nodes.stride);
      for (int first : nodes.near()) {
        const int column = first % nodes.stride, row = first / nodes.stride;
        for (int lane = 0; lane < lanes; ++lane)
          if ((line.axis == 0 ? column + lane : row) == line.at && column + lane < nodes.columns)
            line.ghosts.push_back(first + lane);
      }
    }
  }

  /// Takes what the ghosts were given to the nodes.
  void fold(Field<double>& given) const {
    for (const Line& line : lines_)
      for (int ghost : line.ghosts) {
        const double g = given[ghost];
        given[ghost + line.step] += line.periodic ? g : -g;
        given[ghost] = line.periodic ? 0 : 2 * g;
      }
  }
  /// Makes of a field of the nodes one that cells see.
  void unfold(Field<double>& field) const {
    for (const Line& line : lines_)
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
  struct Line {
    int axis;  // 0: a column of nodes, 1: a row
    bool periodic;
    int at, inner;  // of the ghosts, and of the nodes within
    std::vector<int> ghosts{};
    int step = 0;  // from a ghost to its node within
  };
  std::vector<Line> lines_;
};

/// What the nodes hold within a step. A node that is left out has no mass, and no velocity.
class SplineNodes : public CentreNodes {
 public:
  SplineNodes(const Grid& grid, int block_width)
      : CentreNodes(grid, block_width, 5),
        per_mass(places()),
        start(places()),
        velocity(places()),
        strained(places()),
        expansion(places()),
        edges(grid) {}

  Field<double> per_mass;   // 1/particles
  NodeVectors start;        // m/s  that particles gave
  NodeVectors velocity;     // m/s  with which the nodes move
  NodeVectors strained;     // m/s  by which the fluid is strained: particles gave it anew
  Field<double> expansion;  // -    that particles gave
  Edges edges;

  template <int width>
  void list_near(const CellOrder<width>& order) {
    CentreNodes::list_near(order);
    edges.list_near(*this);
  }
  bool moves(int node) const { return per_mass[node] > 0; }

  void find_mass(int threads) {
    collect(0, per_mass, threads);
    for_near(near(), threads, [&](int node) {
      const Lanes m = load<Lanes>(&per_mass[node]);
      const auto moves = m > fill<Lanes>(Nodes::least_mass);
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
    for_near(near(), threads, [&](int node) { store(given(field, node), &sum[node]); });
    edges.fold(sum);
  }
};

/// The nodes on walls, each with its walls in the order of the scene.
class SplineWalls {
 public:
  /// Throws std::invalid_argument for a wall anywhere but at an edge of the domain that is not periodic.
  SplineWalls(const std::vector<Wall>& walls, const Start& start, const Grid& grid, const SplineNodes& nodes)
      : walls_(walls) {
    for (std::size_t wall = 0; wall < walls.size(); ++wall) {
      const int axis = walls[wall].axis, line = grid.line_of(walls[wall]), cells = axis == 0 ? grid.columns : grid.rows;
      if ((axis == 0 ? grid.periodic_x : grid.periodic_y) || (line > 0 && line < cells))
        throw std::invalid_argument(fmt::format(
            "mpm: wall at {} = {:g} m, expected at an edge of the domain that is not periodic: this shape has no node "
            "of its own elsewhere",
            axis == 0 ? "x" : "y", walls[wall].position));
      const int at = line == 0 ? 0 : cells + 1;
      const bool other_periodic = axis == 0 ? grid.periodic_y : grid.periodic_x;
      const int others = axis == 0 ? grid.rows : grid.columns;
      for (int k = other_periodic; k < others + 2 - other_periodic; ++k) {
        const int column = axis == 0 ? at : k, row = axis == 0 ? k : at;
        const Vec2 along(place(column, grid.columns, grid.periodic_x), place(row, grid.rows, grid.periodic_y));
        all_.push_back(
            {row * nodes.stride + column, wall, start.velocity_at(grid.box.low + grid.cell.cwiseProduct(along))});
      }
    }
    std::stable_sort(all_.begin(), all_.end(), [](const Held& a, const Held& b) { return a.node < b.node; });
  }

  void list_near(const CentreNodes& nodes) {
    held_.clear();
    for (int first : nodes.near()) {
      auto held =
          std::lower_bound(all_.begin(), all_.end(), first, [](const Held& h, int node) { return h.node < node; });
      for (; held < all_.end() && held->node < first + lanes; ++held) held_.push_back(*held);
    }
  }

  /// Makes velocities those of the walls, at a time [s].
  void hold(const SplineNodes& nodes, double time, NodeVectors& velocity) const {
    for (const Held& held : held_)
      if (nodes.moves(held.node)) velocity.set(held.node, walls_[held.wall].at_wall(velocity[held.node], time));
  }
  /// Has the motion of each wall node follow its walls, over the step from `start` [s].
  void hold_motion(SplineNodes& nodes, double start, double dt, bool first_step) const {
    for (auto held = held_.begin(); held < held_.end();) {
      const int node = held->node;
      NodeAtWall at_wall{nodes.start[node], nodes.velocity[node], start, start + dt, first_step, held->of_scene};
      for (; held < held_.end() && held->node == node; ++held) PrescribedMotion::hold(walls_[held->wall], at_wall);
      if (!nodes.moves(node)) continue;
      nodes.start.set(node, at_wall.before);
      nodes.velocity.set(node, at_wall.after);
    }
  }

 private:
  struct Held {
    int node;
    std::size_t wall;
    Vec2 of_scene;  // m/s  velocity of the fluid there when the run starts
  };
  /// Of a column or row of nodes [cells from the low edge].
  static double place(int node, int cells, bool periodic) {
    return periodic ? node % cells - 0.5 : std::clamp(node - 0.5, 0.0, static_cast<double>(cells));
  }

  std::vector<Wall> walls_;
  std::vector<Held> all_, held_;
};

}  // namespace touchstone::mpm
