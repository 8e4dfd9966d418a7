#include "vnv/measures/hidden_motion.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace touchstone::vnv {
namespace {

/// A square lattice of 8 x 8 particles, 1 m apart.
Samples lattice_moving(const std::function<Vec2(int, int)>& velocity) {
  Samples s;
  s.x.resize(2, 64), s.v.resize(2, 64);
  for (int p = 0; p < 64; ++p) {
    s.x.col(p) = Vec2(p % 8, p / 8);
    s.v.col(p) = velocity(p % 8, p / 8);
  }
  return s;
}

TEST(HiddenMotion, IsNoneInAFlowThatIsLinear) {
  EXPECT_NEAR(hidden_motion(lattice_moving([](int x, int y) { return Vec2(1 - 2 * y, 3 + x); }), 1.6), 0, 1e-12);
}

TEST(HiddenMotion, IsNearlyAllOfWhatNeighboursDoInTurn) {
  const auto in_turn = lattice_moving([](int x, int y) { return Vec2((x + y) % 2 == 0 ? 1 : -1, 0); });
  EXPECT_NEAR(hidden_motion(in_turn, 1.6), 1, 0.2);
}

TEST(ClosestPair, IsTheLeastDistance) {
  Samples s = lattice_moving([](int, int) { return Vec2(0, 0); });
  EXPECT_DOUBLE_EQ(closest_pair(s), 1);
  s.x.col(9) = Vec2(2.25, 1);
  EXPECT_DOUBLE_EQ(closest_pair(s), 0.25);
}

}  // namespace
}  // namespace touchstone::vnv
