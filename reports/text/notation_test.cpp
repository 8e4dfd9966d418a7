#include "reports/text/notation.hpp"

#include <gtest/gtest.h>

namespace touchstone::reports {
namespace {

TEST(Numbers, KeepFourSignificantDigits) {
  EXPECT_EQ(printed(0.0159049), "0.0159");
  EXPECT_EQ(printed(3.14159), "3.142");
  EXPECT_EQ(printed(-2.5), "−2.5");
}

TEST(Numbers, SpellPowersOfTenAsInPrint) { EXPECT_EQ(printed(-1.25e-7), "−1.25\u202f×\u202f10^-7"); }

TEST(Numbers, GroupLongOnes) {
  EXPECT_EQ(printed(200000L), "200\u202f000");
  EXPECT_EQ(printed(14400.0), "14\u202f400");
  EXPECT_EQ(printed(-1234567L), "−1\u202f234\u202f567");
  EXPECT_EQ(printed(800L), "800");
}

TEST(Numbers, SayWhatIsNotFinite) {
  EXPECT_EQ(printed(vnv::not_a_number), "nan");
  EXPECT_EQ(printed(-std::numeric_limits<double>::infinity()), "−inf");
  EXPECT_EQ(plain(-vnv::not_a_number), "nan");
}

TEST(Numbers, WithAnIntervalShowAsManyDigitsAsItHas) {
  EXPECT_EQ(with_interval(2.0153, 0.118), "2.02 ± 0.12");
  EXPECT_EQ(with_interval(1.99863, 0.00086), "1.9986 ± 0.0009");
  EXPECT_EQ(with_interval(-0.018, 0.047), "−0.02 ± 0.05");
  EXPECT_EQ(with_interval(1.99989, 0.00002), "1.9999 ± 0.0000");
  EXPECT_EQ(with_interval(2, 0), "2.00 ± 0.00");
  EXPECT_EQ(with_interval(2.29, std::numeric_limits<double>::infinity()), "2.29");
}

TEST(Numbers, StandBesideTheirUnit) {
  EXPECT_EQ(valued(0.5, "%"), "0.5\u202f%");
  EXPECT_EQ(valued(2, ""), "2");
}

TEST(Numbers, AreRoundedToTwoDigitsHoweverSmall) {
  EXPECT_EQ(rounded(51.423, "%"), "51\u202f%");
  EXPECT_EQ(rounded(1234, "s"), "1200\u202fs");
  EXPECT_EQ(rounded(5e-324, ""), "4.941\u202f×\u202f10^-324");
}

TEST(Limits, AreReadAsTheyWereClaimed) {
  EXPECT_EQ(limit({}, 0.07), "<= 0.07");
  EXPECT_EQ(limit(0.8, {}), ">= 0.8");
  EXPECT_EQ(limit(1.9, 2.1), "in [1.9, 2.1]");
  EXPECT_EQ(limit(1.5132, 1.5134), "in [1.5132, 1.5134]");
  EXPECT_EQ(limit(2, 2), "in [2, 2]");
  EXPECT_EQ(limit({}, {}), "");
}

TEST(Limits, ArePrintedWithTheSignsOfPrint) { EXPECT_EQ(printed_limit({}, -0.07), "≤ −0.07"); }

TEST(Counts, HaveTheirNounInThePlural) {
  EXPECT_EQ(counted(1, "pass"), "1 pass");
  EXPECT_EQ(counted(2, "pass"), "2 passes");
  EXPECT_EQ(counted(0, "failure"), "0 failures");
}

TEST(Limits, StandWithTheUnitOfTheirQuantity) {
  EXPECT_EQ(with_unit("L2 v_x", "%"), "L2 v_x [%]");
  EXPECT_EQ(with_unit("order", ""), "order");
}

}  // namespace
}  // namespace touchstone::reports
