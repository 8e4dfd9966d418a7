#include "reports/compare/orders.hpp"

#include "reports/testing.hpp"

#include <gtest/gtest.h>

namespace touchstone::reports {
namespace {

vnv::Record with_orders(const std::string& method, const std::vector<vnv::ObservedOrder>& orders) {
  vnv::Record record = sample_record(method);
  record.orders = orders;
  return record;
}

void claim(vnv::Record& record, const std::string& quantity, double time) {
  vnv::Verdict verdict = sample_verdict(vnv::Outcome::holds, 0.1);
  verdict.quantity = quantity;
  verdict.time = time;
  record.verdicts.push_back(verdict);
}

TEST(Orders, AreComparedInWhatAClaimNames) {
  CaseRecords records{"poiseuille",
                      {with_orders("mpm", {sample_order("L2 v_x, rows [%]", 5), sample_order("L2 v_x [%]", 1),
                                           sample_order("L2 v_x [%]", 2)})}};
  claim(records.records[0], "order of L2 v_x over grid", 1);
  const auto principal = principal_comparison(records, Field::velocity);
  ASSERT_TRUE(principal);
  EXPECT_EQ(principal->subject.quantity, "L2 v_x [%]");
  EXPECT_EQ(principal->subject.time, 1);
}

TEST(Orders, WithoutAClaimAreComparedInTheFirstNormWhenMostMethodsHaveThreeSpacings) {
  const CaseRecords records{"poiseuille",
                            {with_orders("mpm", {sample_order("Linf v_x [%]", 1), sample_order("L2 v_x [%]", 1),
                                                 sample_order("L2 v_x [%]", 2), sample_order("L2 v_x [%]", 3, 2),
                                                 sample_order("L2 v_x, rows [%]", 9)}),
                             with_orders("sph", {sample_order("L2 v_x [%]", 1), sample_order("L2 v_x [%]", 2)})}};
  const auto principal = principal_comparison(records, Field::velocity);
  ASSERT_TRUE(principal);
  EXPECT_EQ(principal->subject.quantity, "L2 v_x [%]");
  EXPECT_EQ(principal->subject.time, 2);
  EXPECT_EQ(principal->lines.size(), 2);
}

TEST(Orders, OfVelocityAreDistinguishedFromThoseOfPressureAndOfAllElse) {
  const CaseRecords records{
      "poiseuille",
      {with_orders("mpm", {sample_order("L2 vorticity [%]"), sample_order("L2 p less its mean [%]"),
                           sample_order("L2 v, per particle [%]")})}};
  EXPECT_EQ(principal_comparison(records, Field::velocity)->subject.quantity, "L2 v, per particle [%]");
  EXPECT_EQ(principal_comparison(records, Field::pressure)->subject.quantity, "L2 p less its mean [%]");
  const CaseRecords others{"poiseuille", {with_orders("mpm", {sample_order("L2 vorticity [%]")})}};
  EXPECT_FALSE(principal_comparison(others, Field::velocity));
}

TEST(Orders, AreShownAlongTheLaddersThatClaimsNameOrElseAlongTheLongest) {
  vnv::ObservedOrder points = sample_order("L2 v_x [%]", 1, 5), spacing = sample_order();
  points.ladder = "points per cell";
  spacing.ladder = "spacing";
  CaseRecords records{
      "poiseuille",
      {with_orders("mpm", {points, sample_order()}), with_orders("sph", {sample_order("L2 v_x [%]", 1, 2), spacing})}};
  EXPECT_EQ(principal_comparison(records, Field::velocity)->lines[0].order.ladder, "points per cell");
  claim(records.records[0], "order of L2 v_x over grid", 1);
  records.records[1].orders[0].ladder = "smoothing length";
  const auto principal = principal_comparison(records, Field::velocity);
  ASSERT_EQ(principal->lines.size(), 2);
  EXPECT_EQ(principal->lines[0].order.ladder, "grid");
  EXPECT_EQ(principal->lines[1].order.ladder, "spacing");
}

TEST(Orders, OfTwoLaddersOfAMethodAreNamedWithThem) {
  vnv::ObservedOrder points = sample_order();
  points.ladder = "points per cell";
  CaseRecords records{"poiseuille",
                      {with_orders("mpm", {sample_order(), points}), with_orders("sph", {sample_order()})}};
  claim(records.records[0], "order of L2 v_x over grid", 1);
  claim(records.records[0], "order of L2 v_x over points per cell", 1);
  const auto principal = principal_comparison(records, Field::velocity);
  ASSERT_EQ(principal->lines.size(), 3);
  EXPECT_EQ(principal->name_of(principal->lines[1]), "mpm, points per cell");
  EXPECT_EQ(principal->name_of(principal->lines[2]), "sph");
  EXPECT_EQ(principal->of_method("mpm").size(), 2);
}

TEST(Orders, GiveAMethodTheSamePlaceInEveryComparison) {
  CaseRecords records{"poiseuille",
                      {with_orders("flip", {}), with_orders("mpm", {sample_order("L2 v_x [%]", 1)}),
                       with_orders("sph", {sample_order("L2 v_x [%]", 1), sample_order("Linf v_x [%]", 1)})}};
  claim(records.records[2], "order of Linf v_x over grid", 1);
  const auto all = order_comparisons(records);
  ASSERT_EQ(all.size(), 2);
  EXPECT_EQ(all[0].lines[1].place, 1);
  EXPECT_EQ(all[1].subject.quantity, "Linf v_x [%]");
  EXPECT_EQ(all[1].lines[0].place, 1);
}

TEST(Orders, WithoutErrorsAreNotCompared) {
  vnv::ObservedOrder order = sample_order();
  order.spacings.clear();
  EXPECT_TRUE(order_comparisons({"poiseuille", {with_orders("mpm", {order})}}).empty());
}

TEST(Orders, HaveAnIdThatIsTheNameOfAFile) {
  EXPECT_EQ((OrderComparison{{"L2 v_x, row means [%]", 0.1}, {}}.id()), "order_L2_v_x_row_means_at_0_1_s");
}

}  // namespace
}  // namespace touchstone::reports
