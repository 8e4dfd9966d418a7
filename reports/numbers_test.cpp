#include "reports/numbers.hpp"

#include <gtest/gtest.h>

namespace touchstone::reports {
namespace {

vnv::Verdict between(std::optional<double> lower, std::optional<double> upper) {
  vnv::Verdict verdict;
  verdict.lower = lower;
  verdict.upper = upper;
  return verdict;
}

TEST(Numbers, KeepFourSignificantDigits) {
  EXPECT_EQ(printed(0.0159049), "0.0159");
  EXPECT_EQ(printed(3.14159), "3.142");
  EXPECT_EQ(printed(-2.5), "−2.5");
}

TEST(Numbers, SpellPowersOfTenAsInPrint) { EXPECT_EQ(printed(-1.25e-7), "−1.25\u202f×\u202f10<sup>−7</sup>"); }

TEST(Numbers, GroupLongOnes) {
  EXPECT_EQ(printed(200000L), "200\u202f000");
  EXPECT_EQ(printed(14400.0), "14\u202f400");
  EXPECT_EQ(printed(-1234567L), "−1\u202f234\u202f567");
  EXPECT_EQ(printed(800L), "800");
}

TEST(Numbers, MarkWhatIsNotFinite) {
  EXPECT_EQ(printed(vnv::not_a_number), "<span class=\"nan\">nan</span>");
  EXPECT_EQ(printed(-std::numeric_limits<double>::infinity()), "<span class=\"nan\">−inf</span>");
  EXPECT_EQ(plain(-vnv::not_a_number), "nan");
}

TEST(Limits, AreReadAsTheyWereClaimed) {
  EXPECT_EQ(limit(between({}, 0.07)), "<= 0.07");
  EXPECT_EQ(limit(between(0.8, {})), ">= 0.8");
  EXPECT_EQ(limit(between(1.9, 2.1)), "in [1.9, 2.1]");
  EXPECT_EQ(limit(between(1.5132, 1.5134)), "in [1.5132, 1.5134]");
  EXPECT_EQ(limit(between(2, 2)), "in [2, 2]");
  EXPECT_EQ(limit(between({}, {})), "");
}

TEST(Limits, StandWithTheUnitOfTheirQuantity) {
  EXPECT_EQ(with_unit("L2 v_x", "%"), "L2 v_x [%]");
  EXPECT_EQ(with_unit("order", ""), "order");
}

}  // namespace
}  // namespace touchstone::reports
