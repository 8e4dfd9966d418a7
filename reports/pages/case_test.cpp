/// Each number on a page is that of the record, in the unit of its heading: numbers that are all different tell which
/// is where.

#include "reports/pages/pages.hpp"

#include "reports/testing.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace touchstone::reports {
namespace case_tables_test {

/// The table of a case with this title; empty without one.
std::string table(const CaseRecords& records, const std::string& title) {
  const std::string html = case_page(records, {}, {});
  const std::size_t begin = html.find("<b>" + title + ".</b>");
  return begin == html.npos ? "" : html.substr(begin, html.find("</table>", begin) - begin);
}

/// The text of each cell of the last row of a table, by the headings of the columns.
std::map<std::string, std::string> last_row(const std::string& html) {
  const auto texts = [](const std::string& row, const std::string& cell) {
    std::vector<std::string> all;
    const std::regex one("<" + cell + "[^>]*>([^\n]*?)</" + cell + ">");
    for (std::sregex_iterator at(row.begin(), row.end(), one), end; at != end; ++at)
      all.push_back(std::regex_replace(std::string((*at)[1]), std::regex("<[^>]*>"), ""));
    return all;
  };
  const std::vector<std::string> headings = texts(html, "th"), cells = texts(html.substr(html.rfind("<tr")), "td");
  EXPECT_EQ(headings.size(), cells.size()) << html;
  std::map<std::string, std::string> row;
  for (std::size_t k = 0; k < std::min(headings.size(), cells.size()); ++k) row[headings[k]] = cells[k];
  return row;
}

using Row = std::map<std::string, std::string>;

CaseRecords records_with(auto&& change) {
  vnv::Record record = sample_record();
  change(record);
  return {"poiseuille", {record}};
}

TEST(TableOfErrors, HasSpacingsInMillimetresAndValuesInTheirUnit) {
  const CaseRecords records = records_with([](vnv::Record& record) {
    record.values = {{"M2", 1.25e-3, 0.5, {"L2 v_x", "%", vnv::Kind::norm}, 3.75},
                     {"M2", 1.25e-3, vnv::not_a_number, {"period", "s", vnv::Kind::value}, 0.625}};
  });
  EXPECT_EQ(last_row(table(records, "Error norms")), (Row{{"method", "mpm"},
                                                          {"level", "M2"},
                                                          {"spacing [mm]", "1.25"},
                                                          {"L2 vx [%]0.5\u202fs", "3.75"},
                                                          {"period [s]", "0.625"}}));
}

TEST(TableOfErrors, HasARowForEachLevelAndAColumnForEachQuantityAndTime) {
  const CaseRecords records = records_with([](vnv::Record& record) {
    const vnv::Quantity l2{"L2 v_x", "%", vnv::Kind::norm}, linf{"Linf v_x", "%", vnv::Kind::norm};
    record.values = {{"M1", 2e-3, 0.5, l2, 1}, {"M1", 2e-3, 0.5, linf, 2}, {"M2", 1e-3, 0.5, l2, 3},
                     {"M1", 2e-3, 1, l2, 4},   {"M2", 1e-3, 1, l2, 5},     {"M2", 1e-3, 1, linf, 6}};
  });
  EXPECT_EQ(last_row(table(records, "Error norms")), (Row{{"method", "mpm"},
                                                          {"level", "M2"},
                                                          {"spacing [mm]", "1"},
                                                          {"L2 vx [%]0.5\u202fs", "3"},
                                                          {"L2 vx [%]1\u202fs", "5"},
                                                          {"Linf vx [%]0.5\u202fs", ""},
                                                          {"Linf vx [%]1\u202fs", "6"}}));
}

TEST(TableOfOrders, HasTheFittedOrderItsFloorAndEachPairBesideItsOwnLevels) {
  const CaseRecords records = records_with([](vnv::Record& record) {
    vnv::ObservedOrder order = sample_order();
    order.time = 0.25;
    order.order = 1.75;
    order.half_width = 0.125;
    order.asymptotic = true;
    order.floor = 0.011;
    order.floor_half_width = 0.002;
    order.order_to_floor = 2.25;
    order.order_to_floor_half_width = 0.0625;
    order.pairwise = {1.5, 1.875};
    record.orders = {order};
  });
  EXPECT_EQ(last_row(table(records, "Observed orders")), (Row{{"method", "mpm"},
                                                              {"ladder", "grid"},
                                                              {"quantity", "L2 vx [%]"},
                                                              {"time [s]", "0.25"},
                                                              {"order", "1.75 ± 0.125"},
                                                              {"trend", "↘\u00a0converging"},
                                                              {"floor", "0.011 ± 0.002 order 2.25 ± 0.0625 towards it"},
                                                              {"pairwise", "1.5 M1–M2, 1.875 M2–M3"}}));
}

TEST(TableOfCost, HasEachNumberInTheUnitOfItsHeading) {
  const CaseRecords records = records_with([](vnv::Record& record) {
    record.runs = {{.level = "M2",
                    .spacing = 2.5e-3,
                    .time_step = 5e-6,
                    .end_time = 0.75,
                    .finished = true,
                    .outcome = "finished",
                    .cost = {.particles = 800,
                             .boundary_particles = 120,
                             .steps = 500,
                             .repeats = 3,
                             .cpu = 0.5,
                             .cpu_lowest = 0.4,
                             .cpu_highest = 0.7,
                             .wall = 1.1,
                             .stepping = 0.9,
                             .harness = 0.1,
                             .peak_memory = 2.25e6}}};
  });
  EXPECT_EQ(last_row(table(records, "Cost")), (Row{{"method", "mpm"},
                                                   {"level", "M2"},
                                                   {"spacing [mm]", "2.5"},
                                                   {"step [µs]", "5"},
                                                   {"end [s]", "0.75"},
                                                   {"particles", "800"},
                                                   {"boundary particles", "120"},
                                                   {"steps completed", "500"},
                                                   {"CPU [s]", "0.5 0.4–0.7"},
                                                   {"runs", "3"},
                                                   {"wall [s]", "1.1"},
                                                   {"harness [%]", "10"},
                                                   {"memory [MB]", "2.25"},
                                                   {"ns per particle-step", "1250"},
                                                   {"million particle-steps/s", "0.8"},
                                                   {"outcome", "finished"}}));
}

TEST(TableOfCost, NamesTheResourceThatIsNoCpuTime) {
  const CaseRecords records = records_with([](vnv::Record& record) {
    record.runs = {sample_run("M2", vnv::not_a_number)};
    record.runs[0].cost.resource = vnv::Resource::gpu;
    record.runs[0].cost.occupied = 12.5;
  });
  EXPECT_EQ(last_row(table(records, "Cost")).at("CPU [s]"), "12.5\u202fGPU\u202fs");
}

TEST(TableOfCost, IsBlankWhereAnotherCodeSaysNothingOfItsSteps) {
  const CaseRecords records = records_with([](vnv::Record& record) { record.runs = {sample_run("M2", 0.5)}; });
  const Row row = last_row(table(records, "Cost"));
  for (const char* column :
       {"step [µs]", "steps completed", "boundary particles", "ns per particle-step", "million particle-steps/s"})
    EXPECT_EQ(row.at(column), "") << column;
  EXPECT_EQ(row.at("CPU [s]"), "0.5");
}

TEST(TableOfClaims, HasValueLimitAndMarginOfEach) {
  vnv::Verdict verdict = sample_verdict(vnv::Outcome::holds, 0.25);
  verdict.spacing = 2.5e-3;
  verdict.time = 0.75;
  const CaseRecords records = records_with([&](vnv::Record& record) { record.verdicts = {verdict}; });
  EXPECT_EQ(last_row(table(records, "Claims")), (Row{{"outcome", "holds"},
                                                     {"method", "mpm"},
                                                     {"level", "M2"},
                                                     {"spacing [mm]", "2.5"},
                                                     {"quantity", "L2 vx"},
                                                     {"time [s]", "0.75"},
                                                     {"value", "1.5\u202f%"},
                                                     {"limit", "≤\u00a01.59\u202f%"},
                                                     {"margin", "25\u202f%"},
                                                     {"limit set by", "literature: Sun et al., table 3"}}));
}

TEST(TableOfClaims, SaysUnderAComparisonWhatExplainsItsError) {
  const CaseRecords records = records_with([](vnv::Record& record) {
    vnv::Verdict order = record.verdicts.front(), other = order;
    order.level = "";
    order.quantity = "order of L2 v_x over files";
    other.quantity = "Linf v_x";
    record.verdicts = {order, other};
    record.runs = {sample_run("M1", 1), sample_run("M2", 1)};
    record.diagnoses = {{.level = "M2",
                         .field = "velocity",
                         .quantities = {"L2 v_x", order.quantity},
                         .error = 3.25,
                         .explanations = {{{{"body <force>", "%", 4.9976, 0.02512}}, 0.9931, true, ""},
                                          {{{"viscosity", "%", -5.125, 0.5}, {"time", "s", 2, 1}}, 0.9, true, ""},
                                          {{{"noise", "%", 1, 1}}, 0.1, false, ""}},
                         .sentence = "a <b>force</b> & more"}};
  });
  const std::string claims = table(records, "Claims"), diagnoses = table(records, "What explains the errors");
  EXPECT_TRUE(contains(claims, "&lt;b&gt;force&lt;/b&gt; &amp; more</small>")) << claims;
  EXPECT_EQ(last_row(claims).at("quantity"), "Linf vx") << "of which nothing was asked";
  EXPECT_TRUE(contains(diagnoses, "body &lt;force&gt; 4.998 ± 0.025\u202f%<")) << diagnoses;
  EXPECT_EQ(last_row(diagnoses), (Row{{"method", "mpm"},
                                      {"level", "M2"},
                                      {"field", "velocity"},
                                      {"error [%]", "3.25"},
                                      {"fitted", "viscosity −5.1 ± 0.5\u202f%, time 2.0 ± 1.0\u202fs"},
                                      {"explained [%]", "90"}}));
}

TEST(TableOfClaims, ShowsTheBestExplanationWhereNoneSuffices) {
  const CaseRecords records = records_with([](vnv::Record& record) {
    record.diagnoses = {
        {.level = "M2",
         .field = "pressure",
         .error = 3,
         .explanations = {{{{"gravity", "%", 5, 1}}, 0.25, false, ""}, {{{"noise", "%", 1, 1}}, 0.1, false, ""}},
         .sentence = "none"}};
  });
  EXPECT_EQ(last_row(table(records, "What explains the errors")).at("fitted"),
            "gravity 5.0 ± 1.0\u202f% does not suffice");
}

TEST(TableOfARecord, HasItsNumbersUnderTheirHeadings) {
  const CaseRecords records = records_with([](vnv::Record& record) {
    record.tables = {
        {"paper", "Table 3", "", {"model", "L2 [%]", "T_p [ms]"}, {{"M1", 3.34, 0.46}, {"M2", 1.59, 2.5}}}};
  });
  EXPECT_EQ(last_row(table(records, "Table 3")), (Row{{"model", "M2"}, {"L2 [%]", "1.59"}, {"Tp [ms]", "2.5"}}));
  EXPECT_TRUE(contains(table(records, "Table 3"), "<th>model</th><th class=\"number\">L2 [%]</th>"))
      << "a heading is aligned as the numbers below it";
}

TEST(TableOfARecord, IsNoneWithoutRows) {
  const CaseRecords records = records_with([](vnv::Record& record) {
    record.tables = {{"paper", "Table 3", "", {"model"}, {}}};
    record.values.clear();
  });
  for (const char* title : {"Table 3", "Error norms"}) EXPECT_EQ(table(records, title), "");
}

}  // namespace case_tables_test
}  // namespace touchstone::reports
