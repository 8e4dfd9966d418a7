#include "vnv/gate/compare_values.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(Kind, GroupsWhatQuantitiesDeclare) {
  EXPECT_EQ(kind_of(vnv::Kind::norm), Kind::error);
  EXPECT_EQ(kind_of(vnv::Kind::deviation), Kind::error);
  EXPECT_EQ(kind_of(vnv::Kind::stability_limit), Kind::stability);
  EXPECT_EQ(kind_of(vnv::Kind::count), Kind::other);
}

}  // namespace
}  // namespace touchstone::gate
