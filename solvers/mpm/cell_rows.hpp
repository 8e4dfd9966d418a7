#pragma once
#include "solvers/mpm/cell_lanes.hpp"
#include "solvers/mpm/cell_order.hpp"
#include "solvers/threads.hpp"

#include <iterator>

namespace touchstone::mpm {

inline void sort_unique(std::vector<int>& nodes) {
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}
/// Nodes, ascending, and those in the row above each.
inline std::vector<int> with_next_row(const std::vector<int>& nodes, int stride) {
  std::vector<int> next(nodes), both;
  for (int& node : next) node += stride;
  std::ranges::set_union(nodes, next, std::back_inserter(both));
  return both;
}
/// Adds the images across a periodic boundary of nodes in the first rows, before `end_of_first`, and in the last, from
/// `last` on, which are the same.
inline void add_images_of_rows(std::vector<int>& nodes, int end_of_first, int last) {
  for (std::size_t k = 0, count = nodes.size(); k < count; ++k) {
    if (nodes[k] < end_of_first) nodes.push_back(nodes[k] + last);
    if (nodes[k] >= last) nodes.push_back(nodes[k] - last);
  }
  sort_unique(nodes);
}

/// Calls work(begin, end) with iterators of where rows of blocks begin, so that each thread has about as many blocks.
template <int width, class Work>
void share_out_rows(const CellOrder<width>& order, int threads, const Work& work) {
  const std::vector<int>& rows = order.rows();
  const auto row_of = [&](Eigen::Index block) { return std::lower_bound(rows.begin(), rows.end(), block); };
  share_out(threads, rows.back(), [&](Eigen::Index begin, Eigen::Index end) { work(row_of(begin), row_of(end)); });
}

/// Writes the lanes that hold a particle, and zero to the others.
template <class Real>
struct IfPresent {
  Mask<Real> present;

  Real operator()(const Real& value, NumberIn<Real>* to) const {
    const Real kept = present ? value : Real{};
    store(kept, to);
    return kept;
  }
  Mask<Real> unless_absent(const Mask<Real>& mask) const { return mask | ~present; }
};

/// Calls work(slot, write) for all particles of a block, one of each cell at a time.
template <class Block, class Work>
void for_particles_of(const Block& block, const Work& work) {
  const Lanes count = converted<Lanes>(block.count.data());
  Lanes k{};
  for (int slot = block.first, end = block.slot(0, block.most()); slot < end; slot += lanes, k += 1)
    work(slot, IfPresent<Lanes>{k < count});
}

/// Calls work(index, block, node) for all blocks, with the first of the nodes around the cells of each.
template <class Particles, class Nodes, class Work>
void for_blocks(const Particles& particles, const Nodes& nodes, int threads, const Work& work) {
  const auto& blocks = particles.order.blocks();
  share_out(threads, static_cast<Eigen::Index>(blocks.size()), [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) work(i, blocks[i], nodes.stride * blocks[i].row + blocks[i].column);
  });
}
/// The same; work(block, node) returns where all particles of a cell are still in it, with plausible densities.
template <class Particles, class Nodes, class Work>
void for_blocks(const Particles& particles, const Nodes& nodes, int threads, std::vector<LaneBits>& calm,
                const Work& work) {
  calm.resize(particles.order.blocks().size());
  for_blocks(particles, nodes, threads,
             [&](Eigen::Index i, const auto& block, int node) { calm[i] = lanes_with<Lanes>(work(block, node)); });
}
inline const Mask<Lanes> calm_so_far = Lanes{} == Lanes{};

}  // namespace touchstone::mpm
