#pragma once
/// Nodes of quadratic B-splines, one at the centre of each cell and a ring of ghosts around them, and how cells give to
/// them.

#include "solvers/mpm/cell_rows.hpp"
#include "solvers/mpm/fields.hpp"
#include "solvers/mpm/grid.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace touchstone::mpm {

/// One number for each function of X, and for each of Y; or for each column of nodes around a cell, and for each row.
template <class Real>
using ThreeByThree = std::array<std::array<Real, 3>, 3>;

/// Nodes row by row, counted from the ghosts: the cell (column, row) has its node at (column + 1, row + 1) and touches
/// the nodes (column, row) to (column + 2, row + 2). Rows are as long as whole blocks of cells and one register more.
///
/// A node is given its sums in three parts, by the rows of cells above, beside and below it, so that rows of cells can
/// be worked on at once and every sum has one order. Only nodes near particles are visited, a register at a time; the
/// parts of all others are zero.
class CentreNodes {
 public:
  /// `fields` are how many numbers a cell gives to a node at once.
  CentreNodes(const Grid& grid, int block_width, int fields)
      : stride(((grid.columns + block_width - 1) / block_width + 1) * block_width),
        columns(grid.columns + 2),
        rows(grid.rows + 2),
        periodic_x_(grid.periodic_x),
        periodic_y_(grid.periodic_y),
        given_(fields) {
    for (auto& parts : given_) parts.fill(Field<double>(places()));
  }

  const int stride, columns, rows;

  int places() const { return stride * rows + lanes; }  // a register more to read past the end
  /// The first of each `lanes` nodes that may be near particles, ascending.
  const std::vector<int>& near() const { return near_; }

  /// Where a row of cells gives to the node row below it, its own and the one above: `towards` 0, 1, 2.
  void give(int field, int towards, int node, const Lanes& share) { store(share, &given_[field][towards][node]); }
  /// What the nodes were given.
  Lanes given(int field, int node) const {
    const auto& parts = given_[field];
    return load<Lanes>(&parts[0][node]) + load<Lanes>(&parts[1][node]) + load<Lanes>(&parts[2][node]);
  }

  template <int width>
  void list_near(const CellOrder<width>& order) {
    for (int node : near_)
      for (auto& field : given_)
        for (auto& part : field) store(Lanes{}, &part[node]);
    std::vector<int> below;  // the nodes below occupied cells
    for (const auto& block : order.blocks()) {
      const int first = block.row * stride;
      for (int column = block.column; column < block.column + width + lanes; column += lanes)
        if (below.empty() || below.back() < first + column) below.push_back(first + column);
    }
    if (periodic_x_) add_images_of_columns(below);
    near_ = with_next_row(with_next_row(below));
    if (periodic_y_) add_images_of_rows();
  }

 private:
  std::vector<int> with_next_row(const std::vector<int>& nodes) const {
    std::vector<int> next(nodes), both;
    for (int& node : next) node += stride;
    std::set_union(nodes.begin(), nodes.end(), next.begin(), next.end(), std::back_inserter(both));
    return both;
  }
  static void sort(std::vector<int>& nodes) {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
  /// Of the ghosts beside the first and the last cell of a row.
  void add_images_of_columns(std::vector<int>& nodes) const {
    for (std::size_t k = 0, count = nodes.size(); k < count; ++k) {
      const int first = nodes[k] / stride * stride;
      for (int column : {0, (columns - 2) / lanes * lanes, (columns - 1) / lanes * lanes})
        nodes.push_back(first + column);
    }
    sort(nodes);
  }
  /// Of the ghosts below the first row of cells and above the last, and of the nodes in these.
  void add_images_of_rows() {
    const std::vector<int> nodes = near_;
    const int cells = (rows - 2) * stride;
    for (const int node : nodes) {
      if (node < 2 * stride) near_.push_back(node + cells);
      if (node >= cells) near_.push_back(node - cells);
    }
    sort(near_);
  }

  bool periodic_x_, periodic_y_;
  std::vector<std::array<Field<double>, 3>> given_;
  std::vector<int> near_;
};

/// What a row of cells gives to its three rows of nodes, from left to right. A node belongs to three cells of the row:
/// what the one on its left and the one at it give waits for the one on its right.
template <int fields>
class GivenToCentres {
 public:
  GivenToCentres(CentreNodes& nodes, int row) : nodes_(nodes), first_(row * nodes.stride) {}

  /// `shares` by column and row of nodes around the cells from `column` on.
  void give(int field, int column, const ThreeByThree<Lanes>& shares) {
    const auto give_row = [&](auto row) {
      auto& [here, right] = waiting_[field][row];
      nodes_.give(field, row, first_ + row * nodes_.stride + column,
                  shares[0][row] + shifted<1>(here, shares[1][row]) + shifted<2>(right, shares[2][row]));
      here = shares[1][row];
      right = shares[2][row];
    };
    for_indices<3>(give_row);
  }
  /// Gives what waits, where no block follows.
  void finish(int column) {
    for (int field = 0; field < fields; ++field) give(field, column, {});
  }

 private:
  struct Waiting {
    Lanes here{}, right{};  // for the nodes at the last cells, and right of them
  };
  CentreNodes& nodes_;
  int first_;
  std::array<std::array<Waiting, 3>, fields> waiting_;
};

/// Has all blocks give to their nodes: give(index, block, to).
template <int fields, int width, class Give>
void give_by_rows(const CellOrder<width>& order, int threads, CentreNodes& nodes, const Give& give) {
  const auto& blocks = order.blocks();
  share_out_rows(order, threads, [&](auto row, auto rows_end) {
    for (; row < rows_end; ++row) {
      GivenToCentres<fields> to(nodes, blocks[row[0]].row);
      for (int i = row[0]; i < row[1]; ++i) {
        give(i, blocks[i], to);
        const int next = blocks[i].column + width;
        if (i + 1 == row[1] || blocks[i + 1].column > next) to.finish(next);
      }
    }
  });
}

}  // namespace touchstone::mpm
