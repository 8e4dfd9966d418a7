#include "solvers/mpm/cell_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace touchstone::mpm {
namespace {

/// Particles that are nothing but a number above zero.
struct Tokens {
  std::vector<int> number;
  int times_rearranged = 0;

  template <class F>
  void for_fields(const F& f) {
    const int* const at = number.data();
    f(number);
    times_rearranged += number.data() != at;
  }
};

/// Tokens 1 to n in the cells named for each.
template <int width>
struct TokensInCells {
  CellOrder<width> order;
  Tokens tokens;

  TokensInCells(int columns, int rows, const std::vector<int>& cell_of) : order(columns, rows, cell_of) {
    tokens.number.assign(order.slots(), 0);
    std::map<int, int> taken;
    for (std::size_t p = 0; p < cell_of.size(); ++p)
      tokens.number[order.slot(cell_of[p], taken[cell_of[p]]++)] = static_cast<int>(p) + 1;
  }

  void carry(int from, int k, int to) { order.carry(tokens, from, k, to); }
  std::vector<int> in(int cell) const {
    std::vector<int> numbers;
    for (int k = 0; k < order.count(cell); ++k) numbers.push_back(tokens.number[order.slot(cell, k)]);
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  }
  /// True if no slot of a block holds a token beyond those counted.
  bool is_clear_elsewhere() const {
    for (const auto& block : order.blocks())
      for (int lane = 0; lane < width; ++lane)
        for (int k = block.count[lane]; k < block.capacity; ++k)
          if (tokens.number[block.slot(lane, k)] != 0) return false;
    return true;
  }
};

/// Carries at random and compares with a full sort, again and again.
template <int width>
void expect_as_sorted(int columns, int rows, int particles, int carries) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> any_cell(0, columns * rows - 1);
  std::vector<int> cell_of(particles);
  for (int p = 0; p < particles; ++p) cell_of[p] = p * columns * rows / particles;
  TokensInCells<width> box(columns, rows, cell_of);
  for (int carried = 0; carried < carries; ++carried) {
    int from = any_cell(random);
    while (box.order.count(from) == 0) from = any_cell(random);
    const int k = carried % box.order.count(from), to = any_cell(random);
    const int p = box.tokens.number[box.order.slot(from, k)] - 1;
    if (to != from) box.carry(from, k, to);
    if (box.order.is_stale()) box.order.list_occupied();
    ASSERT_EQ(cell_of[p], from);
    cell_of[p] = to;
    std::map<int, std::vector<int>> sorted;
    for (int q = 0; q < particles; ++q) sorted[cell_of[q]].push_back(q + 1);
    for (int cell = 0; cell < columns * rows; ++cell) ASSERT_EQ(box.in(cell), sorted[cell]);
    ASSERT_TRUE(box.is_clear_elsewhere());
  }
}

TEST(CellOrder, HoldsTheSameParticlesInEachCellAsAFullSort) {
  expect_as_sorted<4>(6, 3, 40, 2000);
  expect_as_sorted<4>(5, 4, 7, 1000);  // rows that end within a block, blocks that come and go
}

TEST(CellOrder, DoesSoForRegistersOfAnyWidth) {
  expect_as_sorted<2>(5, 3, 40, 1000);
  expect_as_sorted<8>(20, 2, 40, 1000);
}

TEST(CellOrder, KeepsTheParticlesOfNeighbouringCellsSideBySide) {
  const TokensInCells<4> box(8, 1, {4, 5, 6, 7, 4, 5, 6, 7});
  ASSERT_EQ(box.order.blocks().size(), 1U);
  const int first = box.order.blocks()[0].first;
  EXPECT_EQ(std::vector<int>(&box.tokens.number[first], &box.tokens.number[first + 8]),
            (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(CellOrder, ListsOnlyTheBlocksThatHoldParticlesRowByRow) {
  TokensInCells<4> box(1000, 1000, {999999, 5, 4003, 4});
  const auto& blocks = box.order.blocks();
  ASSERT_EQ(blocks.size(), 3U);
  EXPECT_EQ(blocks[0].column, 4);
  EXPECT_EQ(blocks[1].row, 4);
  EXPECT_EQ(blocks[1].column, 0);
  EXPECT_EQ(blocks[2].column, 996);
  EXPECT_EQ(box.order.rows(), (std::vector<int>{0, 1, 2, 3}));
}

TEST(CellOrder, NoticesThatABlockIsFilledOrEmptied) {
  TokensInCells<4> box(12, 1, {1, 1, 9});
  box.carry(1, 0, 9);
  EXPECT_FALSE(box.order.is_stale());
  box.carry(1, 0, 2);
  EXPECT_FALSE(box.order.is_stale());
  box.carry(2, 0, 9);
  EXPECT_TRUE(box.order.is_stale());
  box.order.list_occupied();
  EXPECT_EQ(box.order.blocks().size(), 1U);
  EXPECT_EQ(box.order.count(1), 0);
  box.carry(9, 0, 5);
  EXPECT_TRUE(box.order.is_stale());
  box.order.list_occupied();
  EXPECT_EQ(box.order.blocks().size(), 2U);
  box.carry(9, 0, 1);  // filled again
  box.order.list_occupied();
  EXPECT_EQ(box.order.blocks().size(), 3U);
  EXPECT_EQ(box.order.count(1) + box.order.count(5) + box.order.count(9), 3);
}

TEST(CellOrder, MakesRoomWhereABlockIsFull) {
  constexpr int crowd = 3000;
  std::vector<int> cell_of(crowd);
  for (int p = 0; p < crowd; ++p) cell_of[p] = p % 30;
  TokensInCells<4> box(30, 1, cell_of);
  for (int cell = 1; cell < 30; ++cell)
    while (box.order.count(cell) > 0) box.carry(cell, 0, 0);
  EXPECT_EQ(box.order.count(0), crowd);
  EXPECT_EQ(box.in(0).front(), 1);
  EXPECT_EQ(box.in(0).back(), crowd);
  EXPECT_GE(box.tokens.times_rearranged, 1);
  EXPECT_LT(box.tokens.times_rearranged, 40);  // from 100 to 3000 by an eighth each time is 29 times
}

TEST(CellOrder, LooksAtEachParticleOnceWhenTheyAreCarriedAsTheyAreRead) {
  TokensInCells<4> box(3, 1, {1, 1, 1, 1});
  std::vector<int> seen;
  for (int k = 0; k < box.order.count(1);) {
    const int p = box.tokens.number[box.order.slot(1, k)], to = p % 3;
    seen.push_back(p);
    if (to == 1)
      ++k;
    else
      box.carry(1, k, to);
  }
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(seen, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(box.in(0), (std::vector<int>{3}));
  EXPECT_EQ(box.in(1), (std::vector<int>{1, 4}));
  EXPECT_EQ(box.in(2), (std::vector<int>{2}));
}

}  // namespace
}  // namespace touchstone::mpm
