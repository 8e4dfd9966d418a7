#include "reports/pages/pages.hpp"

#include "reports/testing.hpp"

#include <gtest/gtest.h>

namespace touchstone::reports {
namespace {

/// Poiseuille flow by mpm and sph; Couette flow by mpm, and by sph at one spacing only.
std::vector<CaseRecords> two_flows() {
  std::vector<CaseRecords> cases{{"couette", {sample_record("mpm"), sample_record("sph")}},
                                 {"poiseuille", {sample_record("mpm"), sample_record("sph")}}};
  cases[0].records[0].title = "Couette flow";
  for (auto& records : cases)
    for (auto& record : records.records) {
      record.orders = {sample_order()};
      record.values = errors_of(sample_order());
      record.runs = {sample_run("M1", 1), sample_run("M2", 2), sample_run("M3", 4)};
    }
  cases[0].records[1].orders.clear();
  cases[0].records[1].values.resize(1);
  for (auto& run : cases[1].records[1].runs) run.cost.cpu *= 10;
  return cases;
}

std::string matrix_of(const std::vector<CaseRecords>& cases) {
  return html_of("orders", all_pages().at("orders").content({cases}).data);
}

TEST(OrderMatrix, HasAnOrderWithIntervalTrendAndLinkForEachMethodAndFlow) {
  const std::string html = matrix_of(two_flows());
  EXPECT_TRUE(contains(html, "Couette flow"));
  EXPECT_TRUE(contains(html, "<td class=\"converging\"><a href=\"couette/index.html#order_L2_v_x_at_1_s\""));
  EXPECT_TRUE(contains(html, "2.00 ± 0.10</a><br>↘\u00a0converging</td>"));
}

TEST(OrderMatrix, TellsEachTrendBySignWordAndColour) {
  auto cases = two_flows();
  for (const auto& [trend, words] : {std::pair(vnv::Trend::stalled, "→\u00a0stalled"),
                                     {vnv::Trend::diverging, "↗\u00a0diverging"},
                                     {vnv::Trend::inconclusive, "?\u00a0inconclusive"}}) {
    cases[0].records[0].orders[0].trend = trend;
    const std::string html = matrix_of(cases);
    EXPECT_TRUE(contains(html, std::string("<td class=\"") + word(trend) + "\">")) << words;
    EXPECT_TRUE(contains(html, std::string(words) + "</td>")) << words;
  }
}

TEST(OrderMatrix, SaysWhyACellIsBlank) {
  auto cases = two_flows();
  const std::string once = matrix_of(cases);
  EXPECT_TRUE(contains(once, "<span title=\"measured at fewer than two spacings of a ladder\">–<sup>c</sup></span>"));
  EXPECT_TRUE(contains(once, "<sup>c</sup>&#8239;measured at fewer"));
  EXPECT_FALSE(contains(once, "not run in this flow"));
  cases[0].records[1].values.clear();
  EXPECT_TRUE(contains(matrix_of(cases), "<span title=\"this quantity was not measured at this time\">"));
  cases[0].records.pop_back();
  EXPECT_TRUE(contains(matrix_of(cases), "<span title=\"not run in this flow\">"));
}

TEST(OrderMatrix, NamesTheCheapestMethodOfAFlow) {
  const std::string html = matrix_of(two_flows());
  EXPECT_TRUE(contains(html, "<b>mpm</b><br>4\u202fs to 0.1\u202f%<br><small>sph 40\u202fs</small>")) << html;
  EXPECT_TRUE(contains(html, "<b>mpm</b><br>≤\u202f1\u202fs to 1.6\u202f%<br><small>sph ≤\u202f1\u202fs</small>"))
      << "a method needs no ladder to reach an error: " << html;
  auto cases = two_flows();
  for (vnv::Record& record : cases[0].records) record.host = "n1";
  EXPECT_TRUE(contains(matrix_of(cases), "<small title=\"on n1, ")) << "which machine ran both";
  cases[0].records.pop_back();
  EXPECT_TRUE(contains(matrix_of(cases), "<td class=\"best none\">–</td>")) << "one alone is not the cheapest";
}

TEST(OrderMatrix, ShowsFloorsAndLadders) {
  auto cases = two_flows();
  cases[0].records[0].orders[0].floor = 0.02;
  EXPECT_TRUE(contains(matrix_of(cases), "<small>floor 0.02\u202f%</small>"));
  EXPECT_TRUE(contains(matrix_of(cases), "title=\"3 spacings from 4 to 1 mm, grid\""));
}

TEST(OrderMatrix, OfPressureIsThereWherePressureIsMeasured) {
  auto cases = two_flows();
  EXPECT_FALSE(contains(matrix_of(cases), "Pressure."));
  cases[0].records[0].orders.push_back(sample_order("L2 p [%]"));
  EXPECT_TRUE(contains(matrix_of(cases), "Pressure."));
  EXPECT_TRUE(contains(matrix_of(cases), "couette/index.html#order_L2_p_at_1_s"));
}

TEST(OrderMatrix, EscapesWhatARecordSays) {
  auto cases = two_flows();
  for (auto& record : cases[0].records) record.title = record.method = "<script>";
  cases[0].records[0].orders[0].ladder = "\"><script>";
  EXPECT_FALSE(contains(matrix_of(cases), "<script>"));
}

TEST(OrderMatrix, LeavesOutFlowsWithoutOrders) {
  auto cases = two_flows();
  for (auto& record : cases[0].records) record.orders.clear();
  EXPECT_FALSE(contains(matrix_of(cases), "Couette flow"));
}

}  // namespace
}  // namespace touchstone::reports
