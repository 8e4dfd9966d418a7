#pragma once
/// The nodes of the affine method: one at the centre of each cell, and a ring of ghosts around them.

#include "solvers/mpm/cell_order.hpp"
#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/printed/nodes.hpp"

#include <algorithm>
#include <array>

namespace touchstone::mpm {

/// What a cell gives to its nodes, per mass of a particle: particles, m/s.
template <class Real>
struct Shares {
  Real mass{}, x{}, y{};
};

/// Nodes row by row, counted from the ghosts: the cell (column, row) has its node at (column + 1, row + 1) and touches
/// the nodes (column, row) to (column + 2, row + 2). Rows are as long as whole blocks of cells and one register more.
///
/// A node is given its sums in three parts, by the rows of cells above, beside and below it, so that rows of cells can
/// be worked on at once and every sum has one order. Only nodes near particles are visited, a register at a time; the
/// parts of all others are zero.
class CentreNodes {
 public:
  CentreNodes(const Grid& grid, int block_width)
      : stride(((grid.columns + block_width - 1) / block_width + 1) * block_width),
        columns(grid.columns + 2),
        rows(grid.rows + 2),
        mass(stride * rows),
        momentum(stride * rows),
        velocity(stride * rows),
        periodic_x_(grid.periodic_x),
        periodic_y_(grid.periodic_y) {
    given_.fill({mass, mass, mass});
  }

  const int stride, columns, rows;
  Field<double> mass;    // particles
  NodeVectors momentum;  // m/s
  NodeVectors velocity;  // m/s

  /// The first of each `lanes` nodes that may be near particles, ascending.
  const std::vector<int>& near() const { return near_; }

  /// Where a row of cells gives to the node row below it, its own and the one above: `towards` 0, 1, 2.
  void give(int towards, int node, const Shares<Lanes>& shares) {
    store(shares.mass, &given_[towards].mass[node]);
    store(shares.x, &given_[towards].x[node]);
    store(shares.y, &given_[towards].y[node]);
  }

  /// Adds up what the nodes were given; `push` is a change of velocity [m/s] that all of them feel.
  void collect(const Vec2& push, int threads) {
    for_near(near_, threads, [&](int node) {
      const auto sum = [&](Field<double> Shares<Field<double>>::*what) -> Lanes {
        return load<Lanes>(&(given_[0].*what)[node]) + load<Lanes>(&(given_[1].*what)[node]) +
               load<Lanes>(&(given_[2].*what)[node]);
      };
      const Lanes m = sum(&Shares<Field<double>>::mass);
      store(m, &mass[node]);
      store(Lanes(sum(&Shares<Field<double>>::x) + push.x() * m), &momentum.x[node]);
      store(Lanes(sum(&Shares<Field<double>>::y) + push.y() * m), &momentum.y[node]);
    });
  }

  void find_velocities(int threads) {
    for_near(near_, threads, [&](int node) {
      const Lanes m = load<Lanes>(&mass[node]);
      const auto moves = m > fill<Lanes>(Nodes::least_mass);
      const Lanes per_mass = moves ? 1 / (moves ? m : fill<Lanes>(1)) : Lanes{};
      store(Lanes(per_mass * load<Lanes>(&momentum.x[node])), &velocity.x[node]);
      store(Lanes(per_mass * load<Lanes>(&momentum.y[node])), &velocity.y[node]);
    });
  }

  template <int width>
  void list_near(const CellOrder<width>& order) {
    for (int node : near_)
      for (int towards : {0, 1, 2}) give(towards, node, {});
    near_.clear();
    for (const auto& block : order.blocks())
      for (int row = block.row; row < block.row + 3; ++row) {
        for (int column = 0; column < width + lanes; column += lanes)
          near_.push_back(row * stride + block.column + column);
        if (periodic_x_) {  // the images of the ghosts
          near_.push_back(row * stride);
          near_.push_back(row * stride + (columns - 2) / lanes * lanes);
        }
      }
    if (periodic_y_) add_images_of_rows();
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
  }

 private:
  /// Of the ghosts below the first row of cells and above the last, and of the nodes in these.
  void add_images_of_rows() {
    const std::vector<int> nodes = near_;
    const int cells = (rows - 2) * stride;
    for (const int node : nodes) {
      if (node < 2 * stride) near_.push_back(node + cells);
      if (node >= cells) near_.push_back(node - cells);
    }
  }

  bool periodic_x_, periodic_y_;
  std::array<Shares<Field<double>>, 3> given_;
  std::vector<int> near_;
};

}  // namespace touchstone::mpm
