#pragma once
/// Walls of methods in lanes: across the domain, and with an extent.

#include "solvers/mpm/lanes/grid_update.hpp"
#include "solvers/mpm/walls/held_nodes.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"

namespace touchstone::mpm {

/// A wall with an extent, anywhere between cells. No node stands on it: the field of each row of nodes across it is
/// held at the wall by the impulse that takes the least energy, shared by the three nodes whose splines meet it. Fluid
/// may leave it: what moves off is left alone, so that it never pulls.
class PartialSplineWall {
  using Nodes = LaneNodes<ShapeInLanes<BSpline<2>>>;

 public:
  /// Throws std::invalid_argument for a wall less than a cell from an edge of the domain, where splines are cut off.
  PartialSplineWall(const Wall& wall, const Grid& grid, const Nodes& nodes) : wall_(wall) {
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
  void hold(const Nodes& nodes, double time, NodeVectors& velocity) const {
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
  struct ThreeNodes {  // of a row across the wall
    int first;
    double place;  // m  along the wall
  };
  Wall wall_;
  std::array<double, 3> weights_;
  std::vector<ThreeNodes> rows_;
  int step_;  // from a node to the next across the wall
};

/// No wall with an extent.
struct NoPartialWall {
  template <class Nodes>
  NoPartialWall(const Wall& wall, const Grid& grid, const Nodes&) {
    grid.line_of(wall);  // which refuses it
  }
  template <class Nodes>
  static void hold(const Nodes&, double, NodeVectors&) {}
};

/// The nodes on the walls of a scene, and how they are held there.
template <class Shape>
class LaneWalls {
  using Form = ShapeInLanes<Shape>;
  using Nodes = LaneNodes<Form>;

 public:
  /// Throws std::invalid_argument for a wall where the shape has no node of its own, or with an extent if it holds
  /// none.
  LaneWalls(const std::vector<Wall>& walls, const Start& start, const Grid& grid, const Form& shape, const Nodes& nodes)
      : walls_(walls) {
    const std::array along{NodesAlong(grid.columns, grid.periodic_x, shape.reach(0)),
                           NodesAlong(grid.rows, grid.periodic_y, shape.reach(1))};
    std::vector<HeldNode> all;
    for (std::size_t wall = 0; wall < walls.size(); ++wall) {
      if (walls[wall].is_partial()) {
        partial_.emplace_back(walls[wall], grid, nodes);
        continue;
      }
      const int axis = walls[wall].axis, at = along[axis].alone_at(grid.line_of(walls[wall]), walls[wall]);
      for (int k = along[1 - axis].begin(); k < along[1 - axis].end(); ++k) {
        const int column = axis == 0 ? at : k, row = axis == 0 ? k : at;
        const Vec2 place(along[0].place(column), along[1].place(row));
        all.push_back(
            {row * nodes.stride + column, wall, start.velocity_at(grid.box.low + grid.cell.cwiseProduct(place))});
      }
    }
    held_ = HeldNodes(std::move(all));
  }

  void list_near(const Nodes& nodes) { held_.list_near(nodes.near()); }

  /// Makes velocities those of the walls, at a time [s].
  void hold(const Nodes& nodes, double time, NodeVectors& velocity) const {
    for (const HeldNode& held : held_)
      if (nodes.moves(held.node)) velocity.set(held.node, walls_[held.wall].at_wall(velocity[held.node], time));
    for (const PartialWall& wall : partial_) wall.hold(nodes, time, velocity);
  }
  /// Has the motion of each wall node follow its walls, over the step from `start` [s].
  void hold_motion(Nodes& nodes, double start, double dt, bool first_step) const {
    const auto motion = [&](const HeldNode& held) -> NodeAtWall {
      return {nodes.start[held.node], nodes.velocity[held.node], start, start + dt, first_step, held.of_scene};
    };
    mpm::hold_motion(held_, walls_, &PrescribedMotion::hold, motion, [&](int node, const NodeAtWall& at_wall) {
      if (!nodes.moves(node)) return;
      nodes.start.set(node, at_wall.before);
      nodes.velocity.set(node, at_wall.after);
    });
    for (const PartialWall& wall : partial_) {
      wall.hold(nodes, start, nodes.start);
      wall.hold(nodes, start + dt, nodes.velocity);
    }
  }

 private:
  /// The columns or rows of nodes, as the shape lies along an axis.
  class NodesAlong {
   public:
    NodesAlong(int cells, bool periodic, double reach)
        : cells_(cells), periodic_(periodic), along_(GridAxis{cells, periodic, reach}) {}

    /// Those that are no ghosts of others.
    int begin() const { return periodic_ ? Form::first_of_period : 0; }
    int end() const { return periodic_ ? begin() + cells_ : cells_ + Form::touched - 1; }
    /// Of a node [cells from the low edge].
    double place(int node) const {
      const int of_shape = node - Form::first_node;
      return along_.place(periodic_ ? (of_shape + cells_) % cells_ : of_shape);
    }
    /// As `node_alone_at`.
    int alone_at(int line, const Wall& wall) const {
      const int node = node_alone_at(line, along_, wall) + Form::first_node;
      return periodic_ ? begin() + (node - begin()) % cells_ : node;
    }

   private:
    int cells_;
    bool periodic_;
    AlongAxis<Shape> along_;
  };

  using PartialWall = std::conditional_t<Form::holds_partial_walls, PartialSplineWall, NoPartialWall>;

  std::vector<Wall> walls_;
  HeldNodes held_;
  std::vector<PartialWall> partial_;
};

}  // namespace touchstone::mpm
