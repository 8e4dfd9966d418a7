#include "reports/figures/slope_guides.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace touchstone::reports {
namespace {

/// From and to, in shares of the frame.
using Guide = std::array<double, 4>;

std::vector<Guide> guides_in(const std::string& commands) {
  std::vector<Guide> found;
  const std::string start = "set arrow from graph ";
  for (auto at = commands.find(start); at != std::string::npos; at = commands.find(start, at + 1)) {
    Guide g{};
    EXPECT_EQ(
        std::sscanf(commands.c_str() + at, "set arrow from graph %lf,%lf to graph %lf,%lf", &g[0], &g[1], &g[2], &g[3]),
        4);
    found.push_back(g);
  }
  return found;
}

double slope_of(const Guide& g) { return (g[3] - g[1]) / (g[2] - g[0]); }

TEST(SlopeGuides, HaveTheSlopesOneAndTwoOfTheAxes) {
  const auto guides = guides_in(slope_guides({1, 100}, {0.01, 10}, {}));  // two decades on three
  ASSERT_EQ(guides.size(), 2);
  EXPECT_NEAR(slope_of(guides[0]), 2.0 / 3, 1e-3);
  EXPECT_NEAR(slope_of(guides[1]), 4.0 / 3, 1e-3);
}

TEST(SlopeGuides, StandBelowErrorsThatShrink) {
  for (const auto& g : guides_in(slope_guides({1, 10}, {1, 10}, {{{1, 1}, {10, 10}}}))) {
    EXPECT_GT(g[0], g[1] + 0.05);
    EXPECT_GT(g[2], g[3] + 0.05);
  }
}

TEST(SlopeGuides, GoElsewhereIfTheLowerRightIsTaken) {
  const std::vector<DrawnLine> lines = {{{1, 1}, {10, 10}}, {{1, 1.2}, {10, 1.2}}, {{9, 1}, {9, 10}}, {{5, 1}, {5, 4}}};
  for (const auto& g : guides_in(slope_guides({1, 10}, {1, 10}, lines))) {
    EXPECT_GT(g[1], g[0] + 0.05);
    EXPECT_GT(g[3], g[2]);
  }
}

TEST(SlopeGuides, StayInTheFrameWhateverItsShape) {
  for (const double decades_x : {0.1, 1.0, 5.0})
    for (const double decades_y : {0.1, 1.0, 8.0})
      for (const auto& g : guides_in(slope_guides({1, std::pow(10, decades_x)}, {1, std::pow(10, decades_y)}, {})))
        for (const double share : g) {
          EXPECT_GE(share, 0) << decades_x << " on " << decades_y;
          EXPECT_LE(share, 1) << decades_x << " on " << decades_y;
        }
}

TEST(SlopeGuides, PassOverWhatIsNotANumber) {
  const auto guides = guides_in(slope_guides({1, 10}, {1, 10}, {{{1, NAN}, {10, -1}}}));
  ASSERT_EQ(guides.size(), 2);
  EXPECT_GT(guides[0][0], 0.5);
}

}  // namespace
}  // namespace touchstone::reports
