#include "vnv/command/changes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::vnv::command {
namespace {

Baselines with(const std::vector<Baseline>& rows) { return {.acceptance = {}, .rows = rows}; }
Baseline l2(const std::string& level, double value) {
  return {"mpm", level, 0.1, "L2 [%]", value, value - 1, value + 1, ""};
}

TEST(Changes, AreNoneOfEqualBaselines) { EXPECT_TRUE(changes(with({l2("M1", 2)}), with({l2("M1", 2)})).empty()); }

TEST(Changes, TellOldAndNewAndTheRoomLeft) {
  const std::vector<BaselineChange> found =
      changes(with({l2("M1", 2), l2("M2", 3)}), with({l2("M1", 2), l2("M2", 3.25)}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].margin(), 0.75);
  EXPECT_EQ(found[0].sentence("small"), "small.mpm M2, 0.1 s, L2 [%]: 3 -> 3.25, margin 0.75 of the old tolerance");
}

TEST(Changes, BeyondTheOldLimitsHaveNegativeMargin) {
  const std::vector<BaselineChange> found = changes(with({l2("M1", 2)}), with({l2("M1", -1)}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].margin(), -2);
  EXPECT_NE(found[0].sentence("small").find("beyond it"), std::string::npos);
}

TEST(Changes, SayWhatIsNewAndWhatIsGone) {
  const std::vector<BaselineChange> found = changes(with({l2("M1", 2)}), with({l2("M2", 3)}));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].sentence("small"), "small.mpm M2, 0.1 s, L2 [%]: 3, new");
  EXPECT_EQ(found[1].sentence("small"), "small.mpm M1, 0.1 s, L2 [%]: 2, gone");
  EXPECT_TRUE(std::isnan(found[0].margin()));
}

}  // namespace
}  // namespace touchstone::vnv::command
