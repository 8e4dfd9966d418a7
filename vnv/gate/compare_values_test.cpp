#include "vnv/gate/compare_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
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

TEST(CompareValues, BackwardsOrByTheOtherDirectionTakesBetterForWorse) {
  std::mt19937_64 random(36);
  std::uniform_real_distribution<double> exponent(-6, 6), ratio(1.06, 3);
  for (int trial = 0; trial < 1000; ++trial) {
    const double low = std::pow(10, exponent(random)), high = low * ratio(random);
    for (const std::optional<double> tolerance : {std::optional<double>(), std::optional(0.01 * low)}) {
      EXPECT_EQ(smaller(low, high, tolerance), Change::worse);
      EXPECT_EQ(smaller(high, low, tolerance), Change::better);
      EXPECT_EQ(compare_values(low, high, vnv::Better::larger, tolerance).first, Change::better);
      EXPECT_EQ(compare_values(high, low, vnv::Better::larger, tolerance).first, Change::worse);
    }
  }
}

TEST(CompareValues, KnowsNoUnitAndNoSign) {
  std::mt19937_64 random(36);
  std::uniform_real_distribution<double> magnitude(0.5, 2), share(0, 1);
  const auto any = [&](const auto& choices) {
    return *(choices.begin() + static_cast<long>(random() % choices.size()));
  };
  using vnv::Better;
  std::set<Change> found;
  for (int trial = 0; trial < 2000; ++trial) {
    const double before = magnitude(random),
                 after = before * (1 + any(std::vector{0.01, 0.1, 1.0}) * (share(random) - 0.5));
    const std::optional<double> tolerance =
        any(std::vector<std::optional<double>>{{}, 0.0, 0.02 * before, share(random)});
    const auto judged = [&](Better better, double unit) {
      return compare_values(unit * before, unit * after, better,
                            tolerance ? std::optional(std::abs(unit) * *tolerance) : std::nullopt)
          .first;
    };
    const double unit = std::exp2(static_cast<double>(random() % 40) - 20);  // no digit changes
    for (const auto& [better, of_opposite] :
         {std::pair(Better::smaller, Better::larger), std::pair(Better::larger, Better::smaller),
          std::pair(Better::nearer_zero, Better::nearer_zero), std::pair(Better::undeclared, Better::undeclared)}) {
      const Change change = judged(better, 1);
      found.insert(change);
      EXPECT_EQ(judged(better, unit), change) << before << " " << after << " " << unit;
      EXPECT_EQ(judged(of_opposite, -unit), change) << before << " " << after << " " << -unit;
    }
  }
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
