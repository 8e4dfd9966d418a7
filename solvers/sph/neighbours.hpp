#pragma once
/// Who is near whom: linked cells (Sun et al. 2.5) fill lists that hold for many steps, because they reach a little
/// further than the kernel; and the sum over these lists, the one hot loop of the method.

#include "solvers/sph/particles.hpp"

#include <algorithm>
#include <array>

namespace touchstone::sph {

/// Lists of neighbours for a range of particles, `lanes` particles to a block. Row r of a block holds the r-th
/// neighbour of each of its particles; short lists are filled up with the particle that is nowhere.
struct NeighbourLists {
  Index begin = 0, end = 0;         // the particles that have lists
  std::vector<Index> first_row{0};  // of each block, and one more
  std::vector<int> neighbour;       // [row][lane]

  Index blocks() const { return static_cast<Index>(first_row.size()) - 1; }

  /// Adds a block, short lists filled up with `nobody`.
  void append(const std::array<std::vector<int>, lanes>& near, int nobody) {
    std::size_t rows = 0;
    for (const std::vector<int>& of_lane : near) rows = std::max(rows, of_lane.size());
    const std::size_t start = neighbour.size();
    neighbour.resize(start + rows * lanes, nobody);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      for (std::size_t row = 0; row < near[lane].size(); ++row) neighbour[start + row * lanes + lane] = near[lane][row];
    first_row.push_back(first_row.back() + static_cast<Index>(rows));
  }
};

/// Particles sorted into square cells: the linked-cell search.
class Cells {
 public:
  /// Sorts `count` places; a place that is not finite is refused by the caller.
  Cells(const double* x, const double* y, Index count, double side) : side_(side) {
    low_ = {*std::min_element(x, x + count), *std::min_element(y, y + count)};
    const Vec2 high = {*std::max_element(x, x + count), *std::max_element(y, y + count)};
    columns_ = static_cast<int>((high.x() - low_.x()) / side) + 1;
    rows_ = static_cast<int>((high.y() - low_.y()) / side) + 1;
    first_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
    std::vector<int> cell(count);
    for (Index i = 0; i < count; ++i) ++first_[(cell[i] = at(column(x[i]), row(y[i]))) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    std::vector<int> next(first_.begin(), first_.end() - 1);
    sorted_.resize(count);
    for (Index i = 0; i < count; ++i) sorted_[next[cell[i]]++] = static_cast<int>(i);
  }

  const std::vector<int>& sorted() const { return sorted_; }

  /// Calls visit(j) for each particle in the nine cells around a place, in a fixed order.
  template <class Visit>
  void near(double x, double y, Visit visit) const {
    const int c = column(x), r = row(y);
    for (int k = std::max(r - 1, 0); k <= std::min(r + 1, rows_ - 1); ++k)
      for (int s = first_[at(std::max(c - 1, 0), k)]; s < first_[at(std::min(c + 1, columns_ - 1), k) + 1]; ++s)
        visit(sorted_[s]);
  }

 private:
  int column(double x) const { return static_cast<int>((x - low_.x()) / side_); }
  int row(double y) const { return static_cast<int>((y - low_.y()) / side_); }
  int at(int c, int r) const { return r * columns_ + c; }

  double side_;
  Vec2 low_;
  int columns_, rows_;
  std::vector<int> first_, sorted_;
};

/// Fills `K` lists for the particles [begin, end) in one search: a particle j within `reach` [m] goes to list kind(j),
/// or to none for a kind that is negative.
template <std::size_t K, class Kind>
void fill(const std::array<NeighbourLists*, K>& lists, const Particles& all, const Cells& cells, Index begin, Index end,
          double reach, Kind kind) {
  for (NeighbourLists* list : lists) {
    list->begin = begin;
    list->end = end;
    list->first_row.assign(1, 0);
    list->neighbour.clear();
  }
  std::array<std::array<std::vector<int>, lanes>, K> near;
  for (Index block = begin; block < end; block += lanes) {
    for (auto& of_kind : near)
      for (std::vector<int>& of_lane : of_kind) of_lane.clear();
    for (Index i = block; i < std::min<Index>(block + lanes, end); ++i) {
      const double x = all.x[i], y = all.y[i];
      cells.near(x, y, [&](int j) {
        const double dx = x - all.x[j], dy = y - all.y[j];
        if (dx * dx + dy * dy >= reach * reach || j == i) return;
        if (const int k = kind(j); k >= 0) near[k][i - block].push_back(j);
      });
    }
    for (std::size_t k = 0; k < K; ++k) lists[k]->append(near[k], static_cast<int>(all.nowhere()));
  }
}

/// A block of particles i: their values of a field.
struct Block {
  using Real = Lanes;
  Index first;
  Lanes operator()(const Scalars& field) const { return load(field.data() + first); }
};
/// A row of neighbours j, one for each i.
struct Row {
  using Real = Lanes;
  const int* which;
  Lanes operator()(const Scalars& field) const { return gather(field.data(), which); }
};

/// Distances between i and j [m].
inline Lanes distance(const Particles& all, Block i, Row j) {
  const Lanes dx = i(all.x) - j(all.x), dy = i(all.y) - j(all.y);
  return square_root(dx * dx + dy * dy);
}

/// sums[k][n] = sum over the neighbours j of i of term(i, j)[k], with i a Block and j a Row, and n counted from the
/// first particle that has a list.
template <std::size_t K, class Term>
void sum_over_neighbours(const NeighbourLists& lists, const std::array<double*, K>& sums, Term term) {
  for (Index b = 0; b < lists.blocks(); ++b) {
    const Block i{lists.begin + b * lanes};
    std::array<Lanes, K> total{};
    for (Index row = lists.first_row[b]; row < lists.first_row[b + 1]; ++row) {
      const std::array<Lanes, K> share = term(i, Row{&lists.neighbour[row * lanes]});
      for (std::size_t k = 0; k < K; ++k) total[k] += share[k];
    }
    const Index used = std::min<Index>(lanes, lists.end - i.first);
    for (std::size_t k = 0; k < K; ++k)
      std::memcpy(sums[k] + (i.first - lists.begin), &total[k], used * sizeof(double));
  }
}

}  // namespace touchstone::sph
