#pragma once
#include "vnv/bench/plain_flow.hpp"

#include <vector>

namespace touchstone::bench {

/// Nodes of a background grid, row by row, `layers` of them outside each wall; a channel's last column is its first.
class PlainGrid {
 public:
  /// The cells nearest in size that fit the flow.
  PlainGrid(const PlainFlow& flow, double cell, int layers) : layers_(layers) {
    const bool closed = flow.shape == PlainFlow::Shape::tank;
    const Lattice cells = lattice({.high = flow.size}, cell);
    cell_ = cells.step;
    per_cell_ = cell_.cwiseInverse();
    left_ = closed ? layers : 0;
    columns_ = static_cast<int>(cells.columns) + (closed ? 1 + 2 * layers : 0);
    rows_ = static_cast<int>(cells.rows) + 1 + 2 * layers;
    period_ = closed ? columns_ * cell_.x() : flow.size.x();  // in a tank nothing comes that far
    list_walls(closed);
  }

  Vec2 cell() const { return cell_; }          // m
  Vec2 per_cell() const { return per_cell_; }  // 1/m
  int nodes() const { return columns_ * rows_; }
  /// A place along x [m], brought back into the period.
  double wrapped(double x) const { return x >= period_ ? x - period_ : x < 0 ? x + period_ : x; }

  /// A node by its place in the grid, from that at the origin; columns one off the grid are those at its other end.
  int node(int column, int row) const {
    int c = column + left_;
    if (c >= columns_) c -= columns_;
    if (c < 0) c += columns_;
    return (row + layers_) * columns_ + c;
  }

  /// Nodes on a wall or behind it whose velocity along x, or along y, is held at zero.
  const std::vector<int>& held(int axis) const { return held_[axis]; }

 private:
  void list_walls(bool closed) {
    for (int r = 0; r < rows_; ++r)
      for (int c = 0; c < columns_; ++c) {
        const bool plate = r <= layers_ || r >= rows_ - 1 - layers_;
        const bool side = closed && (c <= layers_ || c >= columns_ - 1 - layers_);
        if (side || (plate && !closed)) held_[0].push_back(r * columns_ + c);
        if (plate) held_[1].push_back(r * columns_ + c);
      }
  }

  int layers_, left_, columns_, rows_;
  Vec2 cell_, per_cell_;
  double period_;
  std::vector<int> held_[2];
};

/// What a plain loop of the material point method works on, with `layers` of nodes outside each wall.
template <class ParticleOfLoop, class NodeOfLoop, int layers>
class PlainMpm {
 public:
  using Particle = ParticleOfLoop;

  PlainMpm(const PlainFlow& flow, double cell, double spacing, double time_step)
      : flow_(flow),
        grid_(flow, cell, layers),
        dt_(time_step),
        particles_(particles_at_rest<Particle>(flow, spacing)),
        nodes_(grid_.nodes()) {}

  const std::vector<Particle>& particles() const { return particles_; }

 protected:
  using Node = NodeOfLoop;

  PlainFlow flow_;
  PlainGrid grid_;
  double dt_;  // s
  std::vector<Particle> particles_;
  std::vector<Node> nodes_;
};

}  // namespace touchstone::bench
