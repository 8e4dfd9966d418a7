#pragma once
#include "solvers/fields.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace touchstone::bench {

/// Places sorted into upright cells at least as wide as the reach of a search; along x the cells may go
/// round.
class PlainCells {
 public:
  /// `period` [m] along x from x = 0; infinite if there is none.
  PlainCells(const std::vector<Vec2>& places, double reach, double period) : round_(std::isfinite(period)) {
    Vec2 high = Vec2::Zero();
    for (const Vec2& x : places) {
      low_ = low_.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    if (round_) low_.x() = 0, high.x() = period;
    const Vec2 size = high - low_;
    columns_ = std::max(1, static_cast<int>(size.x() / reach));
    rows_ = std::max(1, static_cast<int>(size.y() / reach));
    side_ = size.cwiseQuotient(Vec2(columns_, rows_)).cwiseMax(reach);
    inside_.resize(columns_ * rows_);
    for (std::size_t k = 0; k < places.size(); ++k)
      inside_[row(places[k]) * columns_ + column(places[k])].push_back(static_cast<int>(k));
  }

  /// Calls visit(k) for the places in the cell of x and those around it.
  template <class Visit>
  void visit_near(const Vec2& x, Visit visit) const {
    for (int r = std::max(0, row(x) - 1); r <= std::min(rows_ - 1, row(x) + 1); ++r)
      for (int c = column(x) - 1; c <= column(x) + 1; ++c)
        if (round_ || (c >= 0 && c < columns_))
          for (int k : inside_[r * columns_ + (c + columns_) % columns_]) visit(k);
  }

 private:
  int column(const Vec2& x) const { return within((x.x() - low_.x()) / side_.x(), columns_); }
  int row(const Vec2& x) const { return within((x.y() - low_.y()) / side_.y(), rows_); }
  static int within(double cell, int count) { return std::clamp(static_cast<int>(cell), 0, count - 1); }

  bool round_;
  Vec2 low_ = Vec2::Zero(), side_;  // m
  int columns_, rows_;
  std::vector<std::vector<int>> inside_;
};

}  // namespace touchstone::bench
