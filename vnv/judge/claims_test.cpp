#include "vnv/judge/claims.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace touchstone::vnv {
namespace claims_test {

const Quantity l2{"L2 v_x", "%", Kind::norm};
const Place here{"poiseuille", "sph", "S2", 1.25e-5, 1};
const Claim small = at_most(l2, 2.33, literature("Sun et al., table 3, S2"));

TEST(Claim, HoldsUpToItsLimitAndNotBeyond) {
  EXPECT_EQ(judge(small, here, 2.33).outcome, Outcome::holds);
  EXPECT_EQ(judge(small, here, 2.3301).outcome, Outcome::fails);
  EXPECT_EQ(judge(at_least({"order"}, 1, theory("")), here, 0.99).outcome, Outcome::fails);
}

TEST(Claim, IsTwoSidedBetweenLimits) {
  const Claim claim = between(l2, 1, 3, theory(""));
  EXPECT_EQ(judge(claim, here, 0.9).outcome, Outcome::fails);
  EXPECT_EQ(judge(claim, here, 2).outcome, Outcome::holds);
  EXPECT_EQ(judge(claim, here, 3.1).outcome, Outcome::fails);
  EXPECT_DOUBLE_EQ(judge(claim, here, 2).margin, 1);
}

TEST(Claim, FailsForWhatIsNotANumber) {
  EXPECT_EQ(judge(small, here, not_a_number).outcome, Outcome::fails);
  EXPECT_EQ(judge(at_least({"x"}, -1e300, theory("")), here, not_a_number).outcome, Outcome::fails);
  EXPECT_EQ(judge(between({"x"}, -1e300, 1e300, theory("")), here, not_a_number).outcome, Outcome::fails);
}

TEST(Claim, SaysWhereWhatTheValueTheLimitAndWhoSetIt) {
  EXPECT_EQ(
      judge(small, here, 2.51).sentence,
      "poiseuille.sph S2: L2 v_x = 2.51 % at 1 s, limit 2.33 % (literature: Sun et al., table 3, S2), margin -8 %: FAILS");
}

TEST(Claim, CoversItsLevelAndTimeOnly) {
  const Claim claim = small.on("S2").at(0.1);
  EXPECT_TRUE(claim.covers("S2", 0.1 + 1e-12));
  EXPECT_FALSE(claim.covers("S3", 0.1));
  EXPECT_FALSE(claim.covers("S2", 0.2));
  EXPECT_TRUE(small.covers("anything", 7));
}

ObservedOrder order(double value, double half_width) {
  ObservedOrder o;
  o.order = value;
  o.half_width = half_width;
  o.trend = std::isnan(value) ? Trend::inconclusive : Trend::converging;
  return o;
}

TEST(OrderClaim, IsJudgedOnlyWhereTheIntervalIsNarrow) {
  const Claim claim = order_between("grid", l2, 1.9, 2.1, theory(""));
  EXPECT_EQ(judge(claim, here, order(2, 0.1)).outcome, Outcome::holds);
  EXPECT_EQ(judge(claim, here, order(2, 0.5)).outcome, Outcome::inconclusive);
  EXPECT_EQ(judge(claim, here, order(2, std::numeric_limits<double>::infinity())).outcome, Outcome::inconclusive);
  EXPECT_EQ(judge(claim, here, order(1, 0.1)).outcome, Outcome::fails);
}

TEST(OrderClaim, MayAskForMoreLevelsAnotherTimeAndLevel) {
  const Claim claim = order_between("grid", l2, 1.9, 2.1, theory("")).with_at_least_levels(5).at(0.25).on("M2");
  EXPECT_EQ(claim.least_levels, 5);
  EXPECT_EQ(claim.time, 0.25);
  EXPECT_EQ(claim.level, "M2");
}

TEST(OrderClaim, MayAskWhereTheIntervalBegins) {
  const Claim claim = order_at_least("grid", l2, 1.9, 1.75, theory(""));
  EXPECT_EQ(judge(claim, here, order(3, 0.1)).outcome, Outcome::holds);
  EXPECT_EQ(judge(claim, here, order(1.95, 0.25)).outcome, Outcome::fails);
  EXPECT_EQ(judge(claim, here, order(1.85, 0.01)).outcome, Outcome::fails);
  EXPECT_EQ(judge(claim, here, order(1.95, 0.31)).outcome, Outcome::inconclusive);
  EXPECT_EQ(judge(claim, here, order(3, 1)).outcome, Outcome::holds) << "all of the interval lies above";
  EXPECT_EQ(judge(claim, here, order(3, 1.27)).outcome, Outcome::inconclusive);
  EXPECT_EQ(judge(claim, here, order(2.1, 0.34)).outcome, Outcome::holds) << "both that are printed are met";
  EXPECT_EQ(judge(claim, here, order(not_a_number, not_a_number)).outcome, Outcome::fails);
  EXPECT_NE(judge(claim, here, order(3, 0.1)).sentence.find("expected surely above 1.75"), std::string::npos);
}

TEST(OrderClaim, SaysWhetherTheFormalOrderWasReached) {
  const Claim claims[] = {order_at_least("grid", l2, 1.8, 1.5, theory("")).of_formal_order(2),
                          order_between("grid", l2, 1.8, 4, theory("")).of_formal_order(2)};
  for (const Claim& claim : claims) {
    const auto says = [&](double value, double half_width, bool pairs_agree, const std::string& words) {
      ObservedOrder found = order(value, half_width);
      found.asymptotic = pairs_agree;
      return judge(claim, here, found).sentence.find(", " + words) != std::string::npos;
    };
    EXPECT_TRUE(says(2.05, 0.1, true, "asymptotic"));
    EXPECT_TRUE(says(2.05, 0.1, false, "not asymptotic")) << "its pairs have other orders";
    EXPECT_TRUE(says(2.05, 0.25, true, "not asymptotic")) << "not known well enough";
    EXPECT_TRUE(says(2.31, 0.07, true, "above the formal order 2, not asymptotic"));
    EXPECT_TRUE(says(1.85, 0.05, true, "below the formal order 2, not asymptotic"));
  }
}

TEST(OrderClaim, OfConvergenceFailsWhereErrorsStallOrGrow) {
  const Claim claim = order_at_least("grid", l2, 1.9, 1.75, theory(""));
  ObservedOrder found = order(2, 0.1);
  for (const auto& [trend, outcome] :
       {std::pair(Trend::stalled, Outcome::fails), std::pair(Trend::diverging, Outcome::fails),
        std::pair(Trend::inconclusive, Outcome::inconclusive)}) {
    found.trend = trend;
    EXPECT_EQ(judge(claim, here, found).outcome, outcome) << word_of(trend);
  }
}

TEST(OrderClaim, OfConvergenceIsJudgedAboveTheFloor) {
  const Claim claim = order_at_least("grid", l2, 1.9, 1.75, theory(""));
  ObservedOrder found = order(1.5, 0.1);
  found.floor = 0.01;
  found.order_to_floor = 2;
  found.order_to_floor_half_width = 0.05;
  const Verdict verdict = judge(claim, here, found);
  EXPECT_EQ(verdict.outcome, Outcome::holds);
  EXPECT_EQ(verdict.value, 2);
  EXPECT_EQ(verdict.half_width, 0.05);
  EXPECT_NE(verdict.sentence.find("above a floor of 0.01, converging"), std::string::npos) << verdict.sentence;
}

TEST(OrderClaim, FailsForDivergenceAndForNoOrderAtAll) {
  const Claim claim = order_between("grid", l2, 1.9, 2.1, theory(""));
  EXPECT_EQ(judge(claim, here, order(-2, 0.1)).outcome, Outcome::fails);
  EXPECT_EQ(judge(claim, here, order(not_a_number, not_a_number)).outcome, Outcome::fails);
}

}  // namespace claims_test
}  // namespace touchstone::vnv
