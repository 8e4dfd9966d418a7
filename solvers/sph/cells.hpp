#pragma once
/// Particles sorted into square cells: the linked-cell search of Sun et al., section 2.5.

#include "solvers/sph/close_ones.hpp"
#include "solvers/sph/particles.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::sph {

class Cells {
 public:
  /// Sorts those of `count` places that are accepted; a place that is not finite is refused by the caller.
  template <class Accept>
  Cells(const Scalars& x, const Scalars& y, Index count, double side, Accept accept)
      : per_side_(1 / side), low_(Vec2::Constant(1e300)) {
    for_accepted(count, accept, [&](Index i) { low_ = low_.cwiseMin(Vec2(x[i], y[i])); });
    fill(x, y, count, accept);
  }
  /// Fewer of the same places, in the same cells.
  template <class Accept>
  Cells(const Scalars& x, const Scalars& y, Index count, const Cells& all, Accept accept)
      : per_side_(all.per_side_), low_(all.low_) {
    fill(x, y, count, accept);
  }

  /// The accepted particles, cell by cell, each cell in the order of the numbers.
  const std::vector<int>& sorted() const { return sorted_; }

  /// Writes those but `self` that are closer than `reach` to a place into `found`, in a fixed order, and returns how
  /// many they are. `found` grows as needed.
  std::size_t near(const Vec2& place, double reach, int self, std::vector<int>& found) const {
    const int c = column(place.x()), r = row(place.y());
    if (c < -1 || c > columns_) return 0;
    std::size_t count = 0;
    for (int k = std::max(r - 1, 0); k <= std::min(r + 1, rows_ - 1); ++k) {
      const int begin = first_[at(std::max(c - 1, 0), k)], end = first_[at(std::min(c + 1, columns_ - 1), k) + 1];
      if (const std::size_t most = count + (end - begin) + close_ones_overrun; found.size() < most)
        found.resize(2 * most);
      count += close_ones(x_.data() + begin, y_.data() + begin, sorted_.data() + begin, end - begin, place.x(),
                          place.y(), reach, self, found.data() + count);
    }
    return count;
  }

 private:
  template <class Accept, class Work>
  static void for_accepted(Index count, const Accept& accept, const Work& work) {
    for (Index i = 0; i < count; ++i)
      if (accept(i)) work(i);
  }

  template <class Accept>
  void fill(const Scalars& x, const Scalars& y, Index count, const Accept& accept) {
    Vec2 high = low_;
    for_accepted(count, accept, [&](Index i) { high = high.cwiseMax(Vec2(x[i], y[i])); });
    columns_ = column(high.x()) + 1;
    rows_ = row(high.y()) + 1;
    first_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
    std::vector<int> cell(count, -1);
    for_accepted(count, accept, [&](Index i) { ++first_[(cell[i] = at(column(x[i]), row(y[i]))) + 1]; });
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    sort(x, y, cell);
  }

  void sort(const Scalars& x, const Scalars& y, const std::vector<int>& cell) {
    std::vector<int> next(first_.begin(), first_.end() - 1);
    sorted_.resize(first_.back());
    x_.resize(first_.back());
    y_.resize(first_.back());
    for (std::size_t i = 0; i < cell.size(); ++i) {
      if (cell[i] < 0) continue;
      const int slot = next[cell[i]]++;
      sorted_[slot] = static_cast<int>(i);
      x_[slot] = x[static_cast<Index>(i)];
      y_[slot] = y[static_cast<Index>(i)];
    }
  }

  int column(double x) const { return static_cast<int>(std::floor((x - low_.x()) * per_side_)); }
  int row(double y) const { return static_cast<int>(std::floor((y - low_.y()) * per_side_)); }
  int at(int c, int r) const { return r * columns_ + c; }

  double per_side_;  // 1/m
  Vec2 low_;
  int columns_, rows_;
  std::vector<int> first_, sorted_;
  std::vector<double> x_, y_;  // m  in the order of `sorted_`
};

}  // namespace touchstone::sph
