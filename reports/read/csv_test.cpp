#include "reports/read/csv.hpp"

#include "reports/testing.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchstone::reports {
namespace {

TEST(Csv, QuotesOnlyWhatNeedsIt) {
  for (const char* plain : {"L2 v_x [%]", "", "6' pipe"}) EXPECT_EQ(csv_field(plain), plain);
  for (const char* quoted : {"a,b", "two\nlines"}) EXPECT_EQ(csv_field(quoted), fmt::format("\"{}\"", quoted));
  EXPECT_EQ(csv_field("6\" pipe"), "\"6\"\" pipe\"");
}

TEST(Csv, KeepsEmptyFieldsInTheirPlace) { EXPECT_EQ(csv_line({"", "a", ""}), ",a,\n"); }

TEST(Csv, AClaimIsOneLineWithLimitAndAuthor) {
  const std::string csv = verdicts_csv({{"poiseuille", {sample_record()}}});
  EXPECT_TRUE(contains(csv, "\npoiseuille,mpm,M2,,,L2 v_x [%],1.5,<= 1.59,\"literature: Sun et al., table 3\",holds\n"))
      << csv;
}

TEST(Csv, AValueThatIsNotANumberIsSaidToBeNone) {
  vnv::Record record = sample_record();
  record.verdicts[0].value = vnv::not_a_number;
  EXPECT_TRUE(contains(verdicts_csv({{"poiseuille", {record}}}), ",nan,<= 1.59,"));
}

TEST(Csv, AnOrderIsOneLineWithItsIntervalAndItsFloorIfOneWasFound) {
  vnv::Record record = sample_record();
  record.orders = {sample_order(), sample_order("L2 p [%]", 0.5, 2)};
  record.orders[0].floor = 0.02;
  record.orders[0].floor_half_width = 0.001;
  record.orders[0].order_to_floor = 2.5;
  record.orders[0].order_to_floor_half_width = 0.2;
  const std::string csv = orders_csv({{"poiseuille", {record}}});
  EXPECT_TRUE(contains(csv, "\npoiseuille,mpm,grid,L2 v_x [%],1,3,0.001,0.1,2,0.1,converging,no,0.02,0.001,2.5,0.2\n"))
      << csv;
  EXPECT_TRUE(contains(csv, "\npoiseuille,mpm,grid,L2 p [%],0.5,2,0.002,0.4,2,inf,inconclusive,no,,,,\n")) << csv;
}

TEST(Csv, ARunIsOneLineInTheUnitsOfTheHeading) {
  vnv::Record record = sample_record();
  vnv::RunSummary run;
  run.level = "M2";
  run.cost.particles = 1000;
  run.cost.steps = 2000;
  run.cost.cpu = 2;
  run.cost.cpu_lowest = 1.9;
  run.cost.cpu_highest = 2.2;
  run.cost.repeats = 3;
  run.cost.wall = 2.5;
  run.cost.stepping = 2.475;
  run.cost.harness = 0.025;
  run.cost.peak_memory = 5e6;
  record.runs = {run};
  record.host = "n1";
  record.machine = "a machine, 2 processors";
  EXPECT_TRUE(
      contains(cost_csv({{"poiseuille", {record}}}),
               "\npoiseuille,mpm,M2,1000,2000,2,1.9,2.2,3,2.5,1,5,1000,CPU,2,\"n1, a machine, 2 processors\"\n"));
}

}  // namespace
}  // namespace touchstone::reports
