#include "vnv/gate/compare_orders.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::gate {
namespace {

Change moved(double before, double after, double half_width, double explained = 0) {
  vnv::ObservedOrder was, is;
  was.order = before;
  is.order = after;
  was.half_width = is.half_width = half_width;
  return compare_orders(was, is, explained).first;
}

TEST(CompareOrders, FindsAFallByThreeTenthsWorseWhateverTheInterval) {
  for (const double half_width : {0.01, 1.0, HUGE_VAL, vnv::not_a_number}) {
    EXPECT_EQ(moved(2, 1.7, half_width, 1), Change::worse) << half_width;
    EXPECT_EQ(moved(1.7, 2, half_width), std::isfinite(half_width) ? Change::better : Change::unjudged) << half_width;
  }
}

TEST(CompareOrders, FindsASmallFallWorseOnlyWhereIntervalsAreApart) {
  EXPECT_EQ(moved(2, 1.8, 0.09), Change::worse);
  EXPECT_EQ(moved(2, 1.8, 0.11), Change::inconclusive);
  EXPECT_EQ(moved(2, 1.8, HUGE_VAL), Change::inconclusive);
  EXPECT_EQ(moved(2, 1.96, 0.001), Change::same);
  EXPECT_EQ(moved(2, 1.8, 0.001, 0.2), Change::same);
  EXPECT_EQ(moved(1.8, 2, 0.11), Change::same);
}

TEST(CompareOrders, NeverTakesANegativeOrderForAPositiveOne) {
  EXPECT_EQ(moved(2, -2, 0.1), Change::worse);
  EXPECT_EQ(moved(-2, 2, 0.1), Change::better);
}

TEST(CompareOrders, FindsNoNumberAfterOneWorse) {
  EXPECT_EQ(moved(2, vnv::not_a_number, 0.1), Change::worse);
  EXPECT_EQ(moved(vnv::not_a_number, vnv::not_a_number, 0.1), Change::same);
}

TEST(CompareOrders, TakesErrorsOfRoundingForNoOrder) {
  vnv::ObservedOrder was, is;
  was.errors = {1e-14, 1e-15};
  is.errors = {1e-14, 1e-14};
  was.order = 3.3;
  is.order = 0;
  EXPECT_EQ(compare_orders(was, is, 0).first, Change::same);
  is.errors = {0.1, 0.1};
  EXPECT_EQ(compare_orders(was, is, 0).first, Change::worse) << "an error that is none of rounding any more";
}

TEST(CompareOrders, OfTwoRungsTiltByTheirErrorsOverTheLogarithm) {
  EXPECT_NEAR(tilt_by(0.02, {2, 1}), 2 * 0.02 / std::log(2.0), 1e-12);
}

}  // namespace
}  // namespace touchstone::gate
