#include "vnv/gate/compare_values.hpp"

#include "vnv/judge/testing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace touchstone::gate {
namespace {

Change smaller(double before, double after, std::optional<double> tolerance = std::nullopt) {
  return compare_values(before, after, vnv::Better::smaller, tolerance).first;
}

TEST(CompareValues, WithoutABaselineAllowsTwoPerCent) {
  EXPECT_EQ(smaller(1, 1.0199), Change::same);
  EXPECT_EQ(smaller(1, 1.0201), Change::worse);
  EXPECT_EQ(smaller(1, 0.9799), Change::better);
}

TEST(CompareValues, TakesRoundingOfZeroForNoChange) {
  EXPECT_EQ(smaller(0, 9e-13, 0.0), Change::same);
  EXPECT_EQ(smaller(1e-16, 7e-13), Change::same);
  EXPECT_EQ(smaller(0, 1.1e-12, 0.0), Change::worse);
}

TEST(CompareValues, NeverPassesATenthWhateverABaselineAllows) {
  for (const double tolerance : {0.0, 0.02, 0.05, 0.1, 0.2, 0.49})
    EXPECT_GE(smaller(1, 1.1, tolerance), Change::inconclusive);
  for (const double tolerance : {0.0, 0.03, 0.05, 0.1})
    EXPECT_GE(compare_values(1, 0.95, vnv::Better::larger, tolerance).first, Change::inconclusive) << tolerance;
}

TEST(CompareValues, JudgesNothingInsideARoomAsWideAsTheValue) {
  EXPECT_EQ(smaller(1, 1.4, 1.0), Change::unjudged);
  EXPECT_EQ(smaller(1, 1.04, 1.0), Change::same);
  EXPECT_EQ(smaller(1, 2.1, 1.0), Change::worse);
}

TEST(CompareValues, TakesInfinityForNoNumber) {
  EXPECT_EQ(smaller(1, INFINITY), Change::worse);
  EXPECT_EQ(smaller(INFINITY, vnv::not_a_number), Change::same);
  EXPECT_EQ(compare_values(1, INFINITY, vnv::Better::larger, std::nullopt).first, Change::worse);
}

TEST(CompareValues, HasNoOpinionWhereNoDirectionIsDeclared) {
  EXPECT_EQ(compare_values(1, 1.1, vnv::Better::undeclared, std::nullopt).first, Change::inconclusive);
}

RC_GTEST_PROP(CompareValues, BackwardsOrByTheOtherDirectionTakesBetterForWorse, ()) {
  using namespace vnv;
  const double low = any_unit(6), high = low * any_between(1.06, 3);
  for (const std::optional<double> tolerance : {std::optional<double>(), std::optional(0.01 * low)}) {
    RC_ASSERT(smaller(low, high, tolerance) == Change::worse);
    RC_ASSERT(smaller(high, low, tolerance) == Change::better);
    RC_ASSERT(compare_values(low, high, Better::larger, tolerance).first == Change::better);
    RC_ASSERT(compare_values(high, low, Better::larger, tolerance).first == Change::worse);
  }
}

TEST(CompareValues, KnowsNoUnitAndNoSign) {
  using namespace vnv;
  std::set<Change> found;
  EXPECT_TRUE(rc::check([&found] {
    const double before = any_between(1, 2) / any_between(1, 2),
                 after = before * (1 + *rc::gen::element(0.01, 0.1, 1.0) * (any_between(0, 1) - 0.5));
    const auto tolerance = *rc::gen::element(std::optional<double>(), std::optional(0.0), std::optional(0.02 * before),
                                             std::optional(any_between(0, 1)));
    const auto judged = [&](Better better, double unit) {
      return compare_values(unit * before, unit * after, better,
                            tolerance ? std::optional(std::abs(unit) * *tolerance) : std::nullopt)
          .first;
    };
    const double unit = std::exp2(*rc::gen::inRange(-20, 20));  // no digit changes
    for (const auto& [better, of_opposite] :
         {std::pair(Better::smaller, Better::larger), std::pair(Better::larger, Better::smaller),
          std::pair(Better::nearer_zero, Better::nearer_zero), std::pair(Better::undeclared, Better::undeclared)}) {
      const Change change = judged(better, 1);
      found.insert(change);
      RC_ASSERT(judged(better, unit) == change);
      RC_ASSERT(judged(of_opposite, -unit) == change);
    }
  }));
  EXPECT_EQ(found.size(), 5u) << "every change was met";
}

TEST(Kind, GroupsWhatQuantitiesDeclare) {
  EXPECT_EQ(kind_of(vnv::Kind::norm), Kind::error);
  EXPECT_EQ(kind_of(vnv::Kind::deviation), Kind::error);
  EXPECT_EQ(kind_of(vnv::Kind::stability_limit), Kind::stability);
  EXPECT_EQ(kind_of(vnv::Kind::count), Kind::other);
}

}  // namespace
}  // namespace touchstone::gate
