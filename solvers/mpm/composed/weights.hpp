#pragma once
/// Which nodes each particle touches, and by how much, for any shape along the axes: the plain loops over particles and
/// nodes of the composed method.

#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/shapes/along_axis.hpp"
#include "solvers/mpm/walls/node_alone.hpp"
#include "solvers/threads.hpp"

#include <algorithm>
#include <vector>

namespace touchstone::mpm {

/// Calls work(k) for each k of [0, count), shared between threads, with the same bits for any number of them: one copy
/// of the loop, which is not vectorised across indices. In two copies, or in the body and the remainder of a vectorised
/// loop, a compiler may fuse multiply-adds differently.
template <class Work>
void one_by_one(int threads, Index count, const Work& work) {
  const auto some = [&](Index begin, Index end) __attribute__((noinline, noclone)) {
    for (Index k = begin; k < end; ++k) {
      asm volatile("");
      work(k);
    }
  };
  share_out(threads, count, some);
}

/// What ties a particle to a node.
struct Tie {
  double weight;      // -
  Vec2 slope;         // 1/m  of the weight
  Vec2 affine_slope;  // 1/m  by how much the node tells in the affine velocity
  Vec2 arm;           // m    from the particle to the node
};

/// The ties of all particles at the places where they were last found.
template <class Shape>
class Weights {
 public:
  using Along = AlongAxis<Shape>;
  static constexpr int width = Along::width;

  /// For square particles of a side [m] along each axis.
  Weights(const Grid& grid, const Vec2& side)
      : grid_(grid),
        along_{Along(Axis{grid.columns, grid.periodic_x, side.x() / grid.cell.x() / 2}),
               Along(Axis{grid.rows, grid.periodic_y, side.y() / grid.cell.y() / 2})} {}

  int columns() const { return along_[0].nodes(); }
  int rows() const { return along_[1].nodes(); }
  int nodes() const { return columns() * rows(); }

  /// Of a node [m].
  Vec2 place(int node) const {
    return grid_.box.low +
           grid_.cell.cwiseProduct(Vec2(along_[0].place(node % columns()), along_[1].place(node / columns())));
  }

  /// The nodes that alone carry what is at a wall. Throws std::invalid_argument if there are none, or for a wall off
  /// the grid.
  std::vector<int> nodes_on(const Wall& wall) const {
    const int line = node_alone_at(grid_.line_of(wall), along_[wall.axis], wall);
    std::vector<int> found;
    for (int k = 0; k < (wall.axis == 0 ? rows() : columns()); ++k)
      found.push_back(wall.axis == 0 ? node_at(line, k) : node_at(k, line));
    return found;
  }

  /// Finds the ties of particles at places [m] within the domain, but for its periodic boundaries.
  void find(const Vectors& places, int threads) {
    near_.resize(places.cols());
    one_by_one(threads, places.cols(), [&](Index p) {
      const Vec2 along = (places.col(p) - grid_.box.low).cwiseQuotient(grid_.cell);
      near_[p] = {NearAlong(along_[0].near(along.x())), NearAlong(along_[1].near(along.y()))};
    });
    sort_by_row();
  }

  /// Calls give(node, p, tie) for every particle near a node, in the same order whatever the number of threads.
  template <class Give>
  void scatter(int threads, const Give& give) const {
    one_by_one(threads, rows(), [&](Index at) {
      const int row = static_cast<int>(at);
      for (int b = 0; b < width; ++b) {
        const int first = grid_.periodic_y ? wrapped(row - b, rows()) : row - b;
        if (first < 0) continue;
        for (int k = first_[first]; k < first_[first + 1]; ++k) {
          const int p = order_[k];
          for (int a = 0; a < width; ++a) give(node_at(near_[p].x.first + a, row), p, tie(near_[p], a, b));
        }
      }
    });
  }

  /// Calls take(node, tie) for every node near a particle.
  template <class Take>
  void for_nodes_near(Index p, const Take& take) const {
    for (int b = 0; b < width; ++b)
      for (int a = 0; a < width; ++a) take(node_at(near_[p].x.first + a, near_[p].y.first + b), tie(near_[p], a, b));
  }

  /// A field of the nodes at a particle.
  Vec2 at(Index p, const Vectors& field) const {
    Vec2 sum = Vec2::Zero();
    for_nodes_near(p, [&](int node, const Tie& tie) { sum += tie.weight * field.col(node); });
    return sum;
  }

 private:
  /// The nodes near a place along one axis, with affine slopes [per cell].
  struct NearAlong : NearNodes<width> {
    std::array<double, width> affine_slope{};

    NearAlong() = default;
    explicit NearAlong(const NearNodes<width>& nodes)
        : NearNodes<width>(nodes), affine_slope(affine_slopes_of(nodes)) {}
  };
  struct Near {
    NearAlong x, y;
  };

  static int wrapped(int k, int count) { return (k % count + count) % count; }
  int node_at(int column, int row) const {
    return (grid_.periodic_y ? wrapped(row, rows()) : row) * columns() +
           (grid_.periodic_x ? wrapped(column, columns()) : column);
  }

  Tie tie(const Near& near, int a, int b) const {
    const NearAlong &x = near.x, &y = near.y;
    const double per_x = 1 / grid_.cell.x(), per_y = 1 / grid_.cell.y();
    return {.weight = x.weight[a] * y.weight[b],
            .slope = {per_x * x.slope[a] * y.weight[b], per_y * x.weight[a] * y.slope[b]},
            .affine_slope = {per_x * x.affine_slope[a] * y.weight[b], per_y * x.weight[a] * y.affine_slope[b]},
            .arm = {grid_.cell.x() * x.arm[a], grid_.cell.y() * y.arm[b]}};
  }

  /// Lists the particles by the first row of nodes that they touch, each row in the order of the particles.
  void sort_by_row() {
    const auto row_of = [&](const Near& near) {
      return grid_.periodic_y ? wrapped(near.y.first, rows()) : near.y.first;
    };
    first_.assign(rows() + 1, 0);
    for (const Near& near : near_) ++first_[row_of(near) + 1];
    for (int row = 0; row < rows(); ++row) first_[row + 1] += first_[row];
    order_.resize(near_.size());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (std::size_t p = 0; p < near_.size(); ++p) order_[next[row_of(near_[p])]++] = static_cast<int>(p);
  }

  Grid grid_;
  std::array<Along, 2> along_;
  std::vector<Near> near_;          // of each particle
  std::vector<int> first_, order_;  // where each row begins in the list of particles by rows
};

}  // namespace touchstone::mpm
