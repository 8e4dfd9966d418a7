#pragma once
/// Nodes of which every cell touches as many along each axis, and how cells give to them.

#include "solvers/mpm/cell_lanes.hpp"
#include "solvers/mpm/cell_rows.hpp"
#include "solvers/mpm/grid.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace touchstone::mpm {

/// Nodes row by row: the cell (column, row) touches the nodes (column, row) to (column + touched - 1, row + touched -
/// 1). Rows are as long as whole blocks of cells, and as the registers more in which the last of these have nodes.
///
/// A node is given its sums in parts, one by each row of cells that touch it, so that rows of cells can be worked on at
/// once and every sum has one order. Only nodes near particles are visited, a register at a time; the parts of all
/// others are zero.
template <int touched>
class NodesOfCells {
 public:
  /// Registers beyond those of a block in which the block has nodes.
  static constexpr int registers_more = (touched - 1 + lanes - 1) / lanes;

  NodesOfCells(const Grid& grid, int block_width)
      : stride(((grid.columns + block_width - 1) / block_width + (touched - 1 + block_width - 1) / block_width) *
               block_width),
        columns(grid.columns + touched - 1),
        rows(grid.rows + touched - 1),
        periodic_x_(grid.periodic_x),
        periodic_y_(grid.periodic_y) {}

  const int stride, columns, rows;

  /// For so many numbers that a cell gives to a node at once.
  void make_room(int fields) {
    given_.resize(fields);
    for (auto& parts : given_) parts.fill(Field<double>(places()));
  }

  int places() const { return stride * rows + lanes; }  // a register more to read past the end
  /// The first of each `lanes` nodes that may be near particles, ascending.
  const std::vector<int>& near() const { return near_; }

  /// Calls work(node) for those on a column (axis 0) or row (1) of nodes.
  template <class Work>
  void for_near_on(int axis, int line, const Work& work) const {
    for (int first : near_) {
      const int column = first % stride, row = first / stride;
      for (int lane = 0; lane < lanes; ++lane)
        if ((axis == 0 ? column + lane : row) == line && column + lane < columns) work(first + lane);
    }
  }

  /// Where a row of cells gives to the rows of nodes that it touches, from below: `towards` 0 to touched - 1.
  void give(int field, int towards, int node, const Lanes& share) { store(share, &given_[field][towards][node]); }
  /// What the nodes were given.
  Lanes given(int field, int node) const {
    const auto& parts = given_[field];
    Lanes sum = load<Lanes>(&parts[0][node]);
    for_indices<touched - 1>([&](auto part) { sum += load<Lanes>(&parts[part + 1][node]); });
    return sum;
  }

  template <int width>
  void list_near(const CellOrder<width>& order) {
    for (int node : near_)
      for (auto& field : given_)
        for (auto& part : field) store(Lanes{}, &part[node]);
    std::vector<int> below;  // the nodes below occupied cells
    for (const auto& block : order.blocks()) {
      const int first = block.row * stride;
      for (int column = block.column; column < block.column + width + registers_more * lanes; column += lanes)
        if (below.empty() || below.back() < first + column) below.push_back(first + column);
    }
    if (periodic_x_) add_images_of_columns(below);
    near_ = below;
    for (int row = 1; row < touched; ++row) near_ = with_next_row(near_, stride);
    if (periodic_y_) add_images_of_rows(near_, (touched - 1) * stride, (rows - (touched - 1)) * stride);
  }

 private:
  /// The nodes at both ends of a row, which are the same.
  void add_images_of_columns(std::vector<int>& nodes) const {
    for (std::size_t k = 0, count = nodes.size(); k < count; ++k) {
      const int first = nodes[k] / stride * stride;
      for (int column = 0; column < touched - 1; ++column)
        for (int image : {column, column + columns - (touched - 1)}) nodes.push_back(first + image / lanes * lanes);
    }
    sort_unique(nodes);
  }

  bool periodic_x_, periodic_y_;
  std::vector<std::array<Field<double>, touched>> given_;
  std::vector<int> near_;
};

/// With nodes at the centres of cells and a ring of ghosts around them: the node of a cell (column, row) is at
/// (column + 1, row + 1).
using CentreNodes = NodesOfCells<3>;

/// What a row of cells gives to its rows of nodes, from left to right. A node belongs to several cells of the row: what
/// those on its left give waits for the one on its right.
template <int touched, int fields>
class GivenByCells {
 public:
  GivenByCells(NodesOfCells<touched>& nodes, int row) : nodes_(nodes), first_(row * nodes.stride) {}

  /// `shares` by column and row of nodes near the cells from `column` on.
  void give(int field, int column, const Square<Lanes, touched>& shares) {
    for_indices<touched>([&](auto row) {
      auto& waiting = waiting_[field][row];
      Lanes sum = shares[0][row];
      for_indices<touched - 1>([&](auto k) {
        constexpr int to_right = k + 1, blocks_back = to_right / lanes, by = to_right % lanes;
        if constexpr (by == 0)
          sum += waiting[k][blocks_back - 1];
        else if constexpr (blocks_back == 0)
          sum += shifted<by>(waiting[k][0], shares[to_right][row]);
        else
          sum += shifted<by>(waiting[k][blocks_back], waiting[k][blocks_back - 1]);
      });
      nodes_.give(field, row, first_ + row * nodes_.stride + column, sum);
      for_indices<touched - 1>([&](auto k) {
        for (int block = most_waiting - 1; block > 0; --block) waiting[k][block] = waiting[k][block - 1];
        waiting[k][0] = shares[k + 1][row];
      });
    });
  }
  /// Gives what waits, where no block follows, up to that of a column.
  void finish(int column, int next_block) {
    for (int k = 0; k < most_waiting && column < next_block; ++k, column += lanes)
      for (int field = 0; field < fields; ++field) give(field, column, {});
  }

 private:
  static constexpr int most_waiting = NodesOfCells<touched>::registers_more;
  using Waiting = std::array<Lanes, most_waiting>;  // from the last blocks, the nearest first

  NodesOfCells<touched>& nodes_;
  int first_;
  std::array<std::array<std::array<Waiting, touched - 1>, touched>, fields> waiting_{};
};

/// Has all blocks give to their nodes: give(index, block, to).
template <int fields, int width, int touched, class Give>
void give_by_rows(const CellOrder<width>& order, int threads, NodesOfCells<touched>& nodes, const Give& give) {
  constexpr int end_of_row = std::numeric_limits<int>::max();
  const auto& blocks = order.blocks();
  share_out_rows(order, threads, [&](auto row, auto rows_end) {
    for (; row < rows_end; ++row) {
      GivenByCells<touched, fields> to(nodes, blocks[row[0]].row);
      for (int i = row[0]; i < row[1]; ++i) {
        give(i, blocks[i], to);
        to.finish(blocks[i].column + width, i + 1 == row[1] ? end_of_row : blocks[i + 1].column);
      }
    }
  });
}

}  // namespace touchstone::mpm
