#include "solvers/mpm/cell_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace touchstone::mpm {
namespace {

/// Particles that are nothing but a number.
struct Tokens {
  std::vector<int> number;

  int spare() const { return static_cast<int>(number.size()) - 1; }
  void copy(int from, int to) { number[to] = number[from]; }
};

std::vector<int> numbers_in(const CellOrder& order, const Tokens& tokens, int cell) {
  std::vector<int> numbers(tokens.number.begin() + order.begin(cell), tokens.number.begin() + order.end(cell));
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

TEST(CellOrder, HoldsTheSameParticlesInEachCellAsAFullSort) {
  constexpr int cells = 12, particles = 40;
  std::mt19937 random(1);
  std::uniform_int_distribution<int> any_cell(0, cells - 1), any_particle(0, particles - 1);
  std::vector<int> cell_of(particles);
  for (int p = 0; p < particles; ++p) cell_of[p] = p * cells / particles;
  CellOrder order(cells, cell_of);
  Tokens tokens{std::vector<int>(particles + 1)};
  for (int p = 0; p < particles; ++p) tokens.number[p] = p;

  for (int carried = 0; carried < 2000; ++carried) {
    const int slot = any_particle(random), p = tokens.number[slot], to = any_cell(random);
    order.carry(tokens, slot, cell_of[p], to);
    cell_of[p] = to;
    std::map<int, std::vector<int>> sorted;
    for (int q = 0; q < particles; ++q) sorted[cell_of[q]].push_back(q);
    for (int cell = 0; cell < cells; ++cell) ASSERT_EQ(numbers_in(order, tokens, cell), sorted[cell]);
  }
}

TEST(CellOrder, NoticesThatACellIsFilledOrEmptied) {
  CellOrder order(5, {1, 1, 3});
  Tokens tokens{{0, 1, 2, -1}};
  EXPECT_EQ(order.occupied(), (std::vector<int>{1, 3}));
  order.carry(tokens, 0, 1, 3);
  EXPECT_FALSE(order.is_stale());
  order.carry(tokens, 0, 1, 3);
  EXPECT_TRUE(order.is_stale());
  order.list_occupied();
  EXPECT_EQ(order.occupied(), (std::vector<int>{3}));
  order.carry(tokens, 2, 3, 0);
  EXPECT_TRUE(order.is_stale());
  order.list_occupied();
  EXPECT_EQ(order.occupied(), (std::vector<int>{0, 3}));
}

TEST(CellOrder, LooksAtEachParticleOnceWhenSlotsAreReadAsTheyAreCarried) {
  CellOrder order(3, {1, 1, 1, 1});
  Tokens tokens{{0, 1, 2, 3, -1}};
  std::vector<int> seen;
  for (int slot = order.begin(1); slot < order.end(1);) {
    const int p = tokens.number[slot], to = p % 3;
    seen.push_back(p);
    if (to != 1) order.carry(tokens, slot, 1, to);
    if (to <= 1) ++slot;
  }
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(seen, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(numbers_in(order, tokens, 0), (std::vector<int>{0, 3}));
  EXPECT_EQ(numbers_in(order, tokens, 2), (std::vector<int>{2}));
}

}  // namespace
}  // namespace touchstone::mpm
