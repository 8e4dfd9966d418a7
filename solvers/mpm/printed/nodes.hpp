#pragma once
/// What the nodes of the background grid hold during a step.

#include "solvers/mpm/cell_lanes.hpp"
#include "solvers/mpm/cell_rows.hpp"
#include "solvers/mpm/grid.hpp"
#include "solvers/threads.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace touchstone::mpm {

/// What a cell gives to its corners, per mass of a particle: particles, m/s, m/s².
enum Given { mass, momentum_x, momentum_y, force_x, force_y };
inline constexpr int all_given = 5;

/// Calls work(node) for the first node of every register of those near particles.
template <class Work>
void for_near(const std::vector<int>& near, int threads, const Work& work) {
  share_out(threads, static_cast<Eigen::Index>(near.size()), [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) work(near[i]);
  });
}

/// A vector per node.
struct NodeVectors {
  Field<double> x, y;

  explicit NodeVectors(int places) : x(places), y(x) {}
  Vec2 operator[](int node) const { return {x[node], y[node]}; }
  void set(int node, const Vec2& v) {
    x[node] = v.x();
    y[node] = v.y();
  }
};

/// Nodes at the corners of cells, row by row, rows as long as whole blocks of cells and one column more. Across a
/// periodic boundary the first column stands again behind the last cell, or the first row above it, and both images
/// hold the same.
///
/// A node is given its sums in two halves, by the row of cells above it and by the row below, so that rows of cells can
/// be worked on at once and every sum has one order. Only nodes near particles are visited, a register at a time; the
/// sums of all others are zero.
class CornerNodes {
 public:
  CornerNodes(const Grid& grid, int block_width)
      : stride((grid.columns / block_width + 1) * block_width),
        from_above(halves(places(grid))),
        from_below(halves(places(grid))),
        per_mass(places(grid)),
        change(places(grid)),
        displacement(places(grid)),
        velocity(places(grid)),
        columns_(grid.columns),
        periodic_x_(grid.periodic_x),
        periodic_y_(grid.periodic_y),
        top_(grid.rows * stride) {}

  const int stride;  // nodes in a row
  std::array<Field<double>, all_given> from_above, from_below;
  Field<double> per_mass;    // 1/particles  zero for a node that is left out
  NodeVectors change;        // m/s    of velocity over the step, a_i dt
  NodeVectors displacement;  // cells  over the step, v_i dt
  NodeVectors velocity;      // m/s    at the start of the step; from (17) on after it, found anew from the particles

  /// A mass below this is the rounding error of a particle on the edge of its cell; such a node is left out.
  static constexpr double least_mass = 1e-12;  // particles
  bool moves(int node) const { return per_mass[node] > 0; }

  /// The first of each `lanes` nodes that may be near particles.
  const std::vector<int>& near() const { return near_; }

  /// Where a node of the grid stands: twice, if it is on a periodic boundary.
  std::vector<int> images(int node, const Grid& grid) const {
    const int column = node % grid.node_columns(), first = node / grid.node_columns() * stride;
    if (periodic_x_ && column == 0) return {first, first + columns_};
    return {first + column};
  }

  Lanes sum(Given what, int node) const {
    return load<Lanes>(&from_above[what][node]) + load<Lanes>(&from_below[what][node]);
  }

  template <int width>
  void list_near(const CellOrder<width>& order) {
    for (int node : near_) clear(node);
    std::vector<int> below;  // the nodes below occupied cells
    for (std::size_t row = 0; row + 1 < order.rows().size(); ++row)
      add_row(&order.blocks()[order.rows()[row]], &order.blocks()[order.rows()[row + 1]], below);
    near_ = with_next_row(below, stride);
    if (periodic_y_) add_images_of_rows(near_, stride, top_);
    first_of_rows_.clear();
    if (periodic_x_)
      std::copy_if(near_.begin(), near_.end(), std::back_inserter(first_of_rows_),
                   [this](int node) { return node % stride == 0; });
  }
  /// Has the last column have what the first has, across the periodic boundary. What it was given lacks what a row of
  /// cells that does not reach it gave to the first.
  void show_first_column(NodeVectors& of) const {
    for (const int first : first_of_rows_) of.set(first + columns_, of[first]);
  }

  /// Whether this is the last column, which need not be visited, in a register of its own.
  bool last_column_is_alone_at(int column) const { return periodic_x_ && columns_ % lanes == 0 && column == columns_; }

  /// Whether cells that end at this column have their right corners in the first column of nodes.
  bool at_periodic_boundary(int end_column) const { return periodic_x_ && end_column >= columns_; }

  /// Makes the first nodes of a row of cells, and of the row above, ready for what comes to them across the periodic
  /// boundary.
  void open_boundary(int row) {
    for (Field<double>& half : from_above) store(Lanes{}, &half[row * stride]);
    for (Field<double>& half : from_below) store(Lanes{}, &half[(row + 1) * stride]);
  }
  /// Gives the images of the first row of nodes what either was given, once all rows of cells have given.
  void join_rows(Given first, Given last) {
    if (!periodic_y_) return;
    for (int what = first; what <= last; ++what) {
      std::copy_n(&from_above[what][0], stride, &from_above[what][top_]);
      std::copy_n(&from_below[what][top_], stride, &from_below[what][0]);
    }
  }
  /// Adds what both images of the first node of a row hold.
  void join_images(Field<double>& half, int first) const {
    half[first] += half[first + columns_];
    half[first + columns_] = half[first];
  }

 private:
  static std::array<Field<double>, all_given> halves(int places) {
    std::array<Field<double>, all_given> fields;
    fields.fill(Field<double>(places));
    return fields;
  }
  int places(const Grid& grid) const {
    return stride * (grid.rows + 1) + lanes;
  }  // a register more to read past the end

  void clear(int node) {
    for (Field<double>& half : from_above) store(Lanes{}, &half[node]);
    for (Field<double>& half : from_below) store(Lanes{}, &half[node]);
  }
  /// Adds the nodes below a row of cells, ascending.
  template <class Block>
  void add_row(const Block* begin, const Block* end, std::vector<int>& nodes) const {
    constexpr int width = std::tuple_size_v<decltype(begin->count)>;
    const int first = begin->row * stride;
    if (at_periodic_boundary(end[-1].column + width) && begin->column > 0) nodes.push_back(first);
    for (const Block* block = begin; block < end; ++block) {
      for (int lane = 0; lane < width; lane += lanes) nodes.push_back(first + block->column + lane);
      const bool last = block + 1 == end || block[1].column > block->column + width;
      const int next = block->column + width;
      if (last && next < stride && !last_column_is_alone_at(next)) nodes.push_back(first + next);
    }
  }

  int columns_;
  bool periodic_x_, periodic_y_;
  int top_;  // the first node of the last row
  std::vector<int> near_, first_of_rows_;
};

/// Velocity (10), acceleration (11) with a body force `b` [m/s²] that all nodes feel alike, and how far they move (14).
inline void accelerate(CornerNodes& nodes, const Vec2& b, const Vec2& cell, double dt, int threads) {
  const Vec2 cells_per_velocity = dt * cell.cwiseInverse();
  for_near(nodes.near(), threads, [&](int node) {
    const Lanes m = nodes.sum(mass, node);
    const auto moves = m > fill<Lanes>(CornerNodes::least_mass);
    const Lanes per_mass = moves ? 1 / (moves ? m : fill<Lanes>(1)) : Lanes{};
    store(per_mass, &nodes.per_mass[node]);
    const auto along = [&](Given momentum, Given given_force, double everywhere, double scale, Field<double>& velocity,
                           Field<double>& change, Field<double>& displacement) {
      const Lanes v = per_mass * nodes.sum(momentum, node);
      const Lanes dv = moves ? dt * (per_mass * nodes.sum(given_force, node) + everywhere) : Lanes{};
      store(v, &velocity[node]);
      store(dv, &change[node]);
      store(scale * (v + dv), &displacement[node]);
    };
    along(momentum_x, force_x, b.x(), cells_per_velocity.x(), nodes.velocity.x, nodes.change.x, nodes.displacement.x);
    along(momentum_y, force_y, b.y(), cells_per_velocity.y(), nodes.velocity.y, nodes.change.y, nodes.displacement.y);
  });
}

/// Velocity (17), from (10) and what the particles change by (16).
inline void remap_velocity(CornerNodes& nodes, int threads) {
  for_near(nodes.near(), threads, [&](int node) {
    const Lanes per_mass = load<Lanes>(&nodes.per_mass[node]);
    for (auto [momentum, velocity] :
         {std::pair(momentum_x, &nodes.velocity.x), std::pair(momentum_y, &nodes.velocity.y)})
      store(load<Lanes>(&(*velocity)[node]) + per_mass * nodes.sum(momentum, node), &(*velocity)[node]);
  });
}

}  // namespace touchstone::mpm
