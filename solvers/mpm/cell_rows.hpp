#pragma once
#include "solvers/mpm/cell_order.hpp"
#include "solvers/threads.hpp"

namespace touchstone::mpm {

/// Calls work(begin, end) with iterators of where rows of blocks begin, so that each thread has about as many blocks.
template <int width, class Work>
void share_out_rows(const CellOrder<width>& order, int threads, const Work& work) {
  const std::vector<int>& rows = order.rows();
  const auto row_of = [&](Eigen::Index block) { return std::lower_bound(rows.begin(), rows.end(), block); };
  share_out(threads, rows.back(), [&](Eigen::Index begin, Eigen::Index end) { work(row_of(begin), row_of(end)); });
}

}  // namespace touchstone::mpm
