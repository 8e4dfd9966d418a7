#include "reports/compare/cheapest.hpp"

#include "reports/testing.hpp"

#include <gtest/gtest.h>

namespace touchstone::reports {
namespace {

/// mpm falls to 0.1 % in 4 s; sph has 10 times the error and takes half the time; crude stays at 50 %.
CaseRecords three_methods() {
  CaseRecords records{"poiseuille", {sample_record("crude"), sample_record("mpm"), sample_record("sph")}};
  for (auto& record : records.records) {
    record.values = errors_of(sample_order());
    const double share = record.method == "mpm" ? 1 : 0.5;
    record.runs = {sample_run("M1", share * 1), sample_run("M2", share * 2), sample_run("M3", share * 4)};
  }
  for (auto& error : records.records[0].values) error.value = 50;
  for (auto& error : records.records[2].values) error.value *= 10;
  return records;
}

std::optional<Cheapest> found(const CaseRecords& records) { return cheapest(records, {"L2 v_x [%]", 1}); }

TEST(Cheapest, IsAskedForTheSmallestErrorThatTwoMethodsReach) {
  const auto answer = found(three_methods());
  ASSERT_TRUE(answer);
  EXPECT_DOUBLE_EQ(answer->error, 1);
  EXPECT_EQ(answer->best.method, "mpm");
  EXPECT_EQ(answer->next.method, "sph");
  EXPECT_DOUBLE_EQ(answer->next.time.cpu, 2);
}

TEST(Cheapest, InterpolatesBetweenRuns) {
  const auto answer = found(three_methods());
  EXPECT_NEAR(answer->best.time.cpu, 1.265, 1e-3);  // error ~ CPU^-2, and 1.6 % costs 1 s
}

TEST(Cheapest, OfAnotherQuantityOrTimeIsAnotherQuestion) {
  CaseRecords records = three_methods();
  records.records[1].values.push_back({"M1", 4e-3, 1, {"Linf v_x", "%", vnv::Kind::norm}, 1e-9});
  records.records[1].values.push_back({"M1", 4e-3, 0.1, {"L2 v_x", "%", vnv::Kind::norm}, 1e-9});
  EXPECT_NEAR(found(records)->best.time.cpu, 1.265, 1e-3);
  EXPECT_FALSE(cheapest(records, {"Linf v_x [%]", 1}));
}

TEST(Cheapest, ChargesARunOnlyForAsFarAsItWentWhenItWasMeasured) {
  CaseRecords records = three_methods();
  for (auto& run : records.records[2].runs) {
    run.end_time = 10;
    run.cost.cpu *= 10;
  }
  EXPECT_DOUBLE_EQ(found(records)->next.time.cpu, 2);
}

TEST(Cheapest, LeavesOutRunsThatDidNotFinish) {
  CaseRecords records = three_methods();
  records.records[1].runs[2].finished = false;
  records.records[1].runs[1].finished = false;
  EXPECT_DOUBLE_EQ(found(records)->error, 1.6);
}

TEST(Cheapest, IsNotAskedForAcrossMachinesOrOfOneMethod) {
  CaseRecords records = three_methods();
  records.records[2].machine = "another";
  EXPECT_FALSE(found(records));
  records = three_methods();
  records.records.resize(1);
  EXPECT_FALSE(found(records));
  records.records.push_back(records.records[0]);
  EXPECT_FALSE(found(records)) << "two records of one method are one method";
}

}  // namespace
}  // namespace touchstone::reports
