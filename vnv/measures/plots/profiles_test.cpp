#include "vnv/measures/plots/profiles.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv {
namespace {

TEST(PointsOfAProfile, AreDrawnOnceWhereNoReaderTellsThemApart) {
  Curve curve;
  add_points(curve, {{0.1, 0.1, 0.1, 0.5, 0.5}, {2, 2.0001, 2.01, 0, not_a_number}, {}}, 1);
  EXPECT_EQ(curve.x, (std::vector<double>{0.1, 0.1, 0.5, 0.5}));
  EXPECT_EQ(curve.y[0], 2);
  EXPECT_EQ(curve.y[1], 2.01);
  EXPECT_TRUE(std::isnan(curve.y[3]));
}

TEST(PointsOfAProfile, AreOneARowOfFluidAtRest) {
  Curve curve;
  add_points(curve, {{0.1, 0.1, 0.2}, {0, 0, 0}, {}}, 1);
  EXPECT_EQ(curve.x.size(), 2);
}

}  // namespace
}  // namespace touchstone::vnv
