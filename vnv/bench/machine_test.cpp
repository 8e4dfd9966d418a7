#include "vnv/bench/machine.hpp"

#include <gtest/gtest.h>

namespace touchstone::bench {
namespace {

TEST(MemoryLevels, GrowOutwards) {
  const std::vector<MemoryLevel> levels = memory_levels();
  ASSERT_EQ(levels.size(), 4u);
  for (std::size_t k = 1; k < levels.size(); ++k) EXPECT_GT(levels[k].bytes, levels[k - 1].bytes) << levels[k].name;
}

TEST(LevelThatHolds, IsTheSmallestOrElseTheLast) {
  const std::vector<MemoryLevel> levels{{"near", 10}, {"far", 100}, {"farthest", 1000}};
  EXPECT_EQ(level_that_holds(10, levels).name, "near");
  EXPECT_EQ(level_that_holds(11, levels).name, "far");
  EXPECT_EQ(level_that_holds(1e9, levels).name, "farthest");
}

}  // namespace
}  // namespace touchstone::bench
