#include "vnv/measures/water_level.hpp"

#include "solvers/lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace touchstone::vnv {
namespace water_level_test {

constexpr double spacing = 0.1;

/// Blocks of water of equal particles.
Samples water(const std::vector<Box>& blocks) {
  std::vector<Vectors> parts;
  Eigen::Index count = 0;
  for (const Box& block : blocks) {
    parts.push_back(lattice(block, spacing).places());
    count += parts.back().cols();
  }
  Samples s{.x = Vectors(2, count), .density = Scalars::Constant(count, 1000)};
  count = 0;
  for (const Vectors& part : parts) {
    s.x.middleCols(count, part.cols()) = part;
    count += part.cols();
  }
  s.mass = s.density * spacing * spacing;
  return s;
}

TEST(WaterLevel, IsThatOfWaterInOnePieceByEachMeasure) {
  for (const double half_width : {0.05, 0.13, 0.7}) {
    const WaterLevel found = water_level(water({{.high = {2, 0.5}}}), 1.02, half_width, spacing);
    EXPECT_NEAR(found.lowest, 0.5, 1e-12) << half_width;
    EXPECT_NEAR(found.highest, 0.5, 1e-12) << half_width;
    EXPECT_NEAR(found.volume, 0.5, 1e-12) << half_width;
  }
}

TEST(WaterLevel, TellsALowestPieceFromTheHighest) {
  const Samples plunging = water({{.high = {2, 0.5}}, {.low = {0, 0.8}, .high = {2, 1}}});
  const WaterLevel found = water_level(plunging, 1, 0.1, spacing);
  EXPECT_NEAR(found.lowest, 0.5, 1e-12);
  EXPECT_NEAR(found.highest, 1, 1e-12);
  EXPECT_NEAR(found.volume, 0.7, 1e-12);
  EXPECT_NEAR(water_level(plunging, 1, 0.1, spacing, 4).lowest, 1, 1e-12) << "a gap of three is none there";
}

TEST(WaterLevel, OfWaterThatDoesNotReachTheFloorIsNoneAtTheLowest) {
  const WaterLevel jet = water_level(water({{.low = {0, 0.3}, .high = {2, 0.5}}}), 1, 0.1, spacing);
  EXPECT_EQ(jet.lowest, 0);
  EXPECT_NEAR(jet.highest, 0.5, 1e-12);
  EXPECT_NEAR(water_level(water({{.low = {0, 0.2}, .high = {2, 0.5}}}), 1, 0.1, spacing).lowest, 0.5, 1e-12);
}

TEST(WaterLevel, IsOfTheGaugeAndOfNothingBesideIt) {
  const Samples step = water({{.high = {1, 0.5}}, {.low = {1, 0}, .high = {2, 0.2}}});
  EXPECT_NEAR(water_level(step, 1.2, 0.2, spacing).highest, 0.2, 1e-12) << "the step only touches the gauge";
  EXPECT_NEAR(water_level(step, 1.1, 0.2, spacing).volume, 0.25 * 0.5 + 0.75 * 0.2, 1e-12);
  const WaterLevel dry = water_level(step, 3, 0.2, spacing);
  EXPECT_EQ(dry.lowest, 0);
  EXPECT_EQ(dry.highest, 0);
  EXPECT_EQ(dry.volume, 0);
}

TEST(WaterLevel, IsNoNumberForSamplesThatAreNone) {
  Samples s = water({{.high = {2, 0.5}}});
  s.x(0, 3) = not_a_number;
  EXPECT_TRUE(std::isnan(water_level(s, 1, 0.1, spacing).lowest));
  EXPECT_TRUE(std::isnan(water_level(s, 1, 0.1, spacing).volume));
  EXPECT_TRUE(std::isnan(water_level(Samples{}, 1, 0.1, spacing).highest));
  EXPECT_THROW(water_level(s, 1, 0, spacing), std::invalid_argument);
}

}  // namespace water_level_test
}  // namespace touchstone::vnv
