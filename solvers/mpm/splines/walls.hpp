#pragma once
/// Walls of the method with quadratic B-splines: across the domain at its edges, and with an extent anywhere within.

#include "solvers/mpm/splines/nodes.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"

namespace touchstone::mpm {

/// A wall with an extent, anywhere between cells. No node stands on it: the field of each row of nodes across it is
/// held at the wall by the impulse that takes the least energy, shared by the three nodes whose splines meet it. Fluid
/// may leave it: what moves off is left alone, so that it never pulls.
class PartialSplineWall {
 public:
  /// Throws std::invalid_argument for a wall less than a cell from an edge of the domain, where splines are cut off.
  PartialSplineWall(const Wall& wall, const Grid& grid, const SplineNodes& nodes) : wall_(wall) {
    const int axis = wall.axis, cells = axis == 0 ? grid.columns : grid.rows;
    const double place = (wall.position - grid.box.low[axis]) / grid.cell[axis];
    if (!(place >= 1 && place <= cells - 1) || (axis == 0 ? grid.periodic_y : grid.periodic_x))
      throw std::invalid_argument(fmt::format(
          "mpm: wall with an extent at {} = {:g} m, expected a cell or more from the edges of a domain that is not "
          "periodic along it",
          axis == 0 ? "x" : "y", wall.position));
    const int cell = std::min(static_cast<int>(place), cells - 1);
    const double X = place - cell;
    weights_ = {0.5 * (1 - X) * (1 - X), 0.75 - (X - 0.5) * (X - 0.5), 0.5 * X * X};
    const int along = axis == 0 ? nodes.stride : 1, others = axis == 0 ? grid.rows : grid.columns;
    step_ = axis == 0 ? 1 : nodes.stride;
    for (int k = 0; k < others + 2; ++k)
      rows_.push_back({cell * step_ + k * along,
                       grid.box.low[1 - axis] + grid.cell[1 - axis] * std::clamp(k - 0.5, 0.0, 1.0 * others)});
  }

  /// Holds velocities at the wall, at a time [s].
  void hold(const SplineNodes& nodes, double time, NodeVectors& velocity) const {
    const Range part = wall_.extent(time);
    for (const auto& [first, place] : rows_) {
      if (place < part.low || place > part.high) continue;
      Vec2 v = Vec2::Zero();
      double per_mass = 0;  // of the three nodes together, as the wall meets them
      for (int a = 0; a < 3; ++a) {
        v += weights_[a] * velocity[first + a * step_];
        per_mass += weights_[a] * weights_[a] * nodes.per_mass[first + a * step_];
      }
      if (!(per_mass > 0) || v.dot(wall_.normal()) >= 0) continue;
      const Vec2 impulse = (wall_.at_wall(v, time) - v) / per_mass;
      for (int a = 0; a < 3; ++a) {
        const int node = first + a * step_;
        velocity.set(node, velocity[node] + weights_[a] * nodes.per_mass[node] * impulse);
      }
    }
  }

 private:
  struct Row {
    int first;     // of its three nodes
    double place;  // m  along the wall
  };
  Wall wall_;
  std::array<double, 3> weights_;
  std::vector<Row> rows_;
  int step_;  // from a node to the next across the wall
};

/// The nodes on walls, each with its walls in the order of the scene.
class SplineWalls {
 public:
  /// Throws std::invalid_argument for a wall anywhere but at an edge of the domain that is not periodic.
  SplineWalls(const std::vector<Wall>& walls, const Start& start, const Grid& grid, const SplineNodes& nodes)
      : walls_(walls) {
    for (std::size_t wall = 0; wall < walls.size(); ++wall) {
      if (walls[wall].is_partial()) {
        partial_.emplace_back(walls[wall], grid, nodes);
        continue;
      }
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
    for (const PartialSplineWall& wall : partial_) wall.hold(nodes, time, velocity);
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
    for (const PartialSplineWall& wall : partial_) {
      wall.hold(nodes, start, nodes.start);
      wall.hold(nodes, start + dt, nodes.velocity);
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
  std::vector<PartialSplineWall> partial_;
};

}  // namespace touchstone::mpm
