#pragma once
/// Lists of neighbours that hold for many steps, because they reach a little further than the kernel; and the sum over
/// these lists, the one hot loop of the method.

#include "solvers/sph/cells.hpp"
#include "solvers/threads.hpp"

#include <span>

namespace touchstone::sph {

/// Lists of neighbours, `width` particles to a block. The first row of a block holds its particles, row r the r-th
/// neighbour of each; short lists are filled up with the particle that is nowhere, a short block with its first
/// particle. The neighbours of a particle keep their order, whatever the width.
template <int width>
struct NeighbourLists {
  struct ListBlock {
    Index first_row;
    int particles, rows;
  };
  /// What one thread lists and sums for.
  struct ThreadLists {
    std::vector<ListBlock> blocks;
    std::vector<int> rows;  // [row][lane]

    std::span<const int> rows_of(const ListBlock& block) const {
      return {rows.data() + block.first_row * width, static_cast<std::size_t>(block.rows) * width};
    }
  };
  std::vector<ThreadLists> parts{1};
};

/// Collects particles with their neighbours into blocks.
template <int width>
class BlockWriter {
 public:
  using ThreadLists = typename NeighbourLists<width>::ThreadLists;

  BlockWriter(ThreadLists& part, int nobody) : part_(part), nobody_(nobody) {
    part_.blocks.clear();
    part_.rows.clear();
  }
  std::vector<int>& next() { return near_[used_]; }  // where to write the neighbours of the next particle
  void take(int particle, std::size_t neighbours) {
    particle_[used_] = particle;
    count_[used_] = neighbours;
    if (++used_ == width) flush();
  }
  void flush() {
    if (used_ == 0) return;
    const std::size_t start = part_.rows.size(), most = *std::max_element(count_.begin(), count_.begin() + used_);
    part_.blocks.push_back({static_cast<Index>(start / width), used_, static_cast<int>(1 + most)});
    part_.rows.resize(start + (1 + most) * width, nobody_);
    int* rows = part_.rows.data() + start;
    for (int lane = 0; lane < width; ++lane) rows[lane] = particle_[lane < used_ ? lane : 0];
    for (int lane = 0; lane < used_; ++lane)
      for (std::size_t n = 0; n < count_[lane]; ++n) rows[(1 + n) * width + lane] = near_[lane][n];
    used_ = 0;
  }

 private:
  ThreadLists& part_;
  int nobody_, used_ = 0;
  std::array<std::vector<int>, width> near_;
  std::array<int, width> particle_{};
  std::array<std::size_t, width> count_{};
};

/// Keeps all neighbours that were found.
struct KeepAll {
  std::size_t operator()(int, std::vector<int>&, std::size_t found) const { return found; }
};

/// Lists, for the particles [begin, end), those in `cells` that are closer than `reach` [m]; left(particle, list,
/// count) may take some off the list, and returns how many it leaves. Particles without neighbours have no list, unless
/// `empty_too`.
template <int width, class Left = KeepAll>
void fill(NeighbourLists<width>& lists, const Particles& all, const Cells& cells, Index begin, Index end, double reach,
          bool empty_too, int threads, const Left& left = {}) {
  lists.parts.resize(threads);
  share_out(threads, threads, [&](Index first, Index last) {
    for (Index part = first; part < last; ++part) {
      BlockWriter<width> writer(lists.parts[part], static_cast<int>(all.nowhere()));
      const Index count = end - begin;
      for (Index i = begin + count * part / threads; i < begin + count * (part + 1) / threads; ++i) {
        const int self = static_cast<int>(i);
        std::vector<int>& list = writer.next();
        const std::size_t found = left(self, list, cells.near(Vec2(all.x[i], all.y[i]), reach, self, list));
        if (found > 0 || empty_too) writer.take(self, found);
      }
      writer.flush();
    }
  });
}

/// The sums of one block. Everything is inlined here, or vectors would travel through memory.
template <std::size_t K, int width, class Packed, class Term>
[[gnu::flatten]] inline auto sum_of_block(std::span<const int> rows, const Packed* all, const Term& term) {
  using Sum = LanesOf<typename Packed::Number, width>;
  std::array<Sum, K> total;
#pragma GCC unroll 64
  for (std::size_t k = 0; k < K; ++k) total[k] = Sum{};
  const ParticleLanes<Packed, width> i{all, rows.data()};
  for (const int *row = rows.data() + width, *end = rows.data() + rows.size(); row != end; row += width) {
    const auto added = term(i, ParticleLanes<Packed, width>{all, row});
#pragma GCC unroll 64
    for (std::size_t k = 0; k < K; ++k) total[k] += added[k];
  }
  return total;
}

/// For each particle i that has a list: give(i, made), with made = finish(i, sums), as many numbers as it makes of
/// sums[k] = sum over its neighbours j of term(i, j)[k], in the order of the list; for term and finish i and j are
/// Rows, and sums are Lanes of as many particles.
template <std::size_t K, int width, class Packed, class Term, class Finish, class Give>
void sum_over_neighbours(const NeighbourLists<width>& lists, const std::vector<Packed>& all, const Term& term,
                         const Finish& finish, const Give& give) {
  const int parts = static_cast<int>(lists.parts.size());
  share_out(parts, parts, [&](Index first, Index last) {
    for (Index p = first; p < last; ++p) {
      for (const auto& block : lists.parts[p].blocks) {
        const std::span<const int> rows = lists.parts[p].rows_of(block);
        const auto made = finish(ParticleLanes<Packed, width>{all.data(), rows.data()},
                                 sum_of_block<K, width>(rows, all.data(), term));
        for (int lane = 0; lane < block.particles; ++lane) {
          std::array<double, std::tuple_size_v<std::remove_cvref_t<decltype(made)>>> of_particle;
          for (std::size_t k = 0; k < of_particle.size(); ++k) of_particle[k] = made[k][lane];
          give(Index{rows[lane]}, of_particle);
        }
      }
    }
  });
}

/// The same with the sums as they are.
template <std::size_t K, int width, class Packed, class Term, class Give>
void sum_over_neighbours(const NeighbourLists<width>& lists, const std::vector<Packed>& all, const Term& term,
                         const Give& give) {
  sum_over_neighbours<K>(
      lists, all, term, [](const auto& /*i*/, const auto& sums) -> const auto& { return sums; }, give);
}

}  // namespace touchstone::sph
