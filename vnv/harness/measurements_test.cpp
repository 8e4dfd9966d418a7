#include "vnv/harness/measurements.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace touchstone::vnv {
namespace {

Record record_with(const std::string& quantity, double value) {
  Record record;
  Verdict verdict;
  verdict.quantity = quantity;
  verdict.unit = "mm";
  verdict.level = "M2";
  verdict.time = 0.1;
  verdict.value = value;
  verdict.margin = 0.1;
  verdict.outcome = Outcome::holds;
  record.verdicts = {verdict};
  return record;
}

TEST(Measurements, HaveANameWithUnitRungAndTime) {
  EXPECT_EQ(measurement_lines(record_with("L2 v_x", 1.25)),
            "<CTestMeasurement type=\"numeric/double\" name=\"L2 v_x [mm], M2, 0.1 s\">1.25</CTestMeasurement>\n");
}

TEST(Measurements, AreEscapedForXml) {
  const std::string lines = measurement_lines(record_with("\"a\" < b & c > d", 1));
  EXPECT_NE(lines.find("name=\"&quot;a&quot; &lt; b &amp; c &gt; d [mm], M2, 0.1 s\""), std::string::npos) << lines;
}

TEST(Measurements, LeaveOutWhatIsNotFinite) {
  EXPECT_EQ(measurement_lines(record_with("L2 v_x", not_a_number)), "");
  EXPECT_EQ(measurement_lines(record_with("L2 v_x", INFINITY)), "");
}

TEST(Measurements, AreSomeDozensAtMostAndOrdersAndCostAreAmongThem) {
  Record record = record_with("L2 v_x", 1);
  record.verdicts.resize(1000, record.verdicts.front());
  for (std::size_t i = 0; i < record.verdicts.size(); ++i) record.verdicts[i].level = std::to_string(i);
  RunSummary run{.level = "M3", .finished = true};
  run.cost.cpu = 2;
  run.cost.steps = run.cost.particles = 10;
  record.runs = {run};
  ObservedOrder order;
  order.ladder = "grid";
  order.quantity = "L2 v_x [%]";
  order.time = 1;
  order.order = 1.98;
  order.errors = {4, 1, 0.25};
  record.orders = {order};
  const std::string lines = measurement_lines(record);
  EXPECT_EQ(std::ranges::count(lines, '\n'), 40);
  EXPECT_NE(lines.find("\"CPU [s], M3\">2<"), std::string::npos) << lines;
  EXPECT_NE(lines.find("\"order of L2 v_x over grid, 1 s\">1.98<"), std::string::npos) << lines;
}

TEST(Measurements, OfOneNameAreOne) {
  Record record = record_with("L2 v_x", 1);
  record.verdicts.push_back(record.verdicts.front());
  const std::string lines = measurement_lines(record);
  EXPECT_EQ(std::ranges::count(lines, '\n'), 1);
}

}  // namespace
}  // namespace touchstone::vnv
