#include "reports/read/fault_trials.hpp"

#include "reports/pages/pages.hpp"
#include "reports/testing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace touchstone::reports {
namespace {

class SeededFaults : public testing::Test {
 protected:
  FaultTrials read(const std::string& rows, const std::string& above = sample_fault_keys()) const {
    std::ofstream(folder / "trials.csv") << above + fault_table(rows);
    return read_fault_trials(folder / "trials.csv");
  }
  std::string refusal(const std::string& rows, const std::string& above = sample_fault_keys()) const try {
    read(rows, above);
    return "read without complaint";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  static std::string page_of(const FaultTrials& all) {
    return html_of("faults", all_pages().at("faults").content({{}, {}, all}).data);
  }
  std::string page(const std::string& rows) const { return page_of(read(rows)); }

  ScratchFolder folder;
};

TEST_F(SeededFaults, StandWithTheirTestsWhatIsOpenFirstAndWhatWasHardlyNoticedNext) {
  const FaultTrials all = read(sample_fault_rows());
  EXPECT_EQ(all.trials[0].revision, "abc1234");
  EXPECT_EQ(all.suite, "the tests that each fault names");
  std::vector<std::string> names;
  for (const FaultTrial& trial : all.trials) names.push_back(trial.fault);
  EXPECT_EQ(names, (std::vector<std::string>{"lives", "alarm", "dark", "formula", "near", "far", "broken", "renamed"}));
  EXPECT_EQ(all.trials[0].why, "no flow has such a wall, yet");
  EXPECT_EQ(all.trials[0].tests.size(), 2u);
}

TEST_F(SeededFaults, AreCountedByDayAndInAllBesideFalseAlarms) {
  EXPECT_EQ(read(sample_fault_rows()).sentence(),
            "4 of 6 seeded faults noticed by day (66.7\u202f%), 5 in all (83.3\u202f%); 1 false alarm from 2 harmless "
            "changes.");
  EXPECT_EQ(read("a,A,f,noticed,,t.mpm,yes,-1,\n").sentence(),
            "1 of 1 seeded fault noticed by day (100.0\u202f%), 1 in all (100.0\u202f%).");
  EXPECT_EQ(read("a,A,f,stays green,,t.mpm,no,1,\n").sentence(), "0 false alarms from 1 harmless change.");
  EXPECT_EQ(read("a,A,f,stays green,,t.mpm,no,1,\n", "# machine: x\n# tests: y\n# untried: 7\n").sentence(),
            "0 false alarms from 1 harmless change; 7 not tried yet.");
}

TEST_F(SeededFaults, AreNoticedByTheTestWithTheLargestMarginIfAnyHasOne) {
  const auto clearest = [&](const std::string& rows) {
    const FaultTrials all = read(rows);
    const FaultTest* found = all.trials[0].clearest();
    return found ? found->name : "none";
  };
  const std::string a = "a,A,f,noticed,,";
  EXPECT_EQ(clearest(a + "unit.x,yes,,\n" + a + "t.mpm,yes,-0.2,\n" + a + "t.sph,yes,-3,\n"), "t.sph");
  EXPECT_EQ(clearest(a + "t.mpm,yes,-3,\n" + a + "t.sph,yes,-inf,\n" + a + "unit.x,yes,,\n"), "t.sph");
  EXPECT_EQ(clearest(a + "t.mpm,no,0.1,\n" + a + "unit.x,yes,,\n"), "unit.x");
  EXPECT_EQ(clearest("a,A,f,survived,,t.mpm,no,0.1,\n"), "none");
}

TEST_F(SeededFaults, ThatAreDescribedBadlyAreRefusedByTheirLine) {
  EXPECT_TRUE(contains(refusal("a,A,f,seen,,t,yes,,\n"), "trials.csv:5: conclusion 'seen', expected one such as"));
  EXPECT_TRUE(contains(refusal("a,A,f,noticed,,t,1,,\n"), "noticed '1', expected yes or no"));
  EXPECT_TRUE(contains(refusal("a,A,f,noticed,,t,yes,lots,\n"), "margin [-] 'lots', expected a number or nothing"));
  EXPECT_TRUE(contains(refusal("a,A,f,noticed,,,yes,,\n"), "no test, expected one"));
  EXPECT_TRUE(contains(refusal("a,A,f,noticed,,t,yes\n"), "found 10, expected 12 cells"));
  EXPECT_TRUE(
      contains(refusal("a,A,f,noticed,,t,yes,,\na,B,f,noticed,,u,yes,,\n"), "trials.csv:6: fault 'a' is described"));
  EXPECT_TRUE(
      contains(refusal("a,A,f,noticed,,t,yes,,\n", "# machine: x\n"), "no line '# untried: ...' above the columns"));
  EXPECT_TRUE(contains(refusal("a,A,f,noticed,,t,yes,,\n", "# machine: x\n# tests: y\n# untried: some\n"),
                       "untried 'some', expected how many"));
  EXPECT_TRUE(contains(refusal(""), "no rows"));
  EXPECT_THROW(read_fault_trials(folder / "nowhere.csv"), std::runtime_error);
}

TEST_F(SeededFaults, OfAPageSayFirstWhatIsOpenAndWhatIsKnownOfWhy) {
  const std::string html = page(sample_fault_rows());
  EXPECT_TRUE(contains(html, "<p class=\"sum fails\">4 of 6 seeded faults")) << "a false alarm is not explained";
  EXPECT_LT(html.find("Open.</b>"), html.find("Faults.</b>"));
  EXPECT_TRUE(contains(html, "no flow has such a wall, yet"));
  EXPECT_TRUE(contains(html, "flow.mpm <small class=\"holds\">30\u202f%</small>"))
      << "how much the closest test has left";
}

TEST_F(SeededFaults, OfAPageSayWhenTheyWereTriedAndAtWhichRevisions) {
  const std::string row = "a,A,f,noticed,,t,yes,-1,,", columns = fault_table("");
  const std::string first = row + "abc1234,2026-11-22T04:00:00Z,00ff\n", second = "b" + row.substr(1);
  std::ofstream(folder / "trials.csv") << sample_fault_keys() + columns + first
                                       << second + "def5678,2026-11-20T23:00:00Z,00ff\n";
  const std::string html = page_of(read_fault_trials(folder / "trials.csv"));
  EXPECT_TRUE(contains(html, "between 2026-11-20T23:00:00Z and 2026-11-22T04:00:00Z")) << html;
  EXPECT_TRUE(contains(html, "revisions <code>def5678</code> to <code>abc1234</code>"));
  EXPECT_TRUE(contains(page("a,A,f,noticed,,t,yes,-1,\n"), "at revision <code>abc1234</code>"));
}

TEST_F(SeededFaults, OfAPageAreGoodIfAllAreNoticedOrItIsKnownWhyNot) {
  EXPECT_TRUE(contains(page("a,A,f,noticed at night,,nightly.t.mpm,yes,-1,\n"), "class=\"sum holds\""));
  EXPECT_FALSE(contains(page("a,A,f,noticed,,t.mpm,yes,-1,\n"), "Open.</b>"));
  EXPECT_TRUE(contains(page("a,A,f,survived,why,t.mpm,no,1,\n"), "class=\"sum known\""));
  EXPECT_TRUE(contains(page("a,A,f,survived,,t.mpm,no,1,\n"), "class=\"sum fails\""));
  EXPECT_TRUE(contains(page("a,A,f,survived,,t.mpm,no,1,\n"), "none yet"));
}

TEST_F(SeededFaults, OfAPageAreListedWithTheTestsThatNoticed) {
  const std::string html = page(sample_fault_rows());
  EXPECT_TRUE(contains(html, "<td class=\"number\">−3583\u202f%</td><td class=\"number\">2 of 2</td>")) << html;
  EXPECT_TRUE(contains(html, "<span title=\"flow.mpm: L2 = 2: FAILS\">flow.mpm <small class=\"fails\">−3583\u202f%"));
  std::string rows;
  for (int i = 0; i < 8; ++i) rows += fmt::format("a,A,f,noticed,,t.m{},yes,-{},\n", i, i + 1);
  EXPECT_TRUE(contains(page(rows), "t.m3 <small class=\"fails\">−400\u202f%</small></span> <small>and 3 more</small>"));
}

TEST_F(SeededFaults, AreAMatrixOfMarginsInWhichUnitTestsOfAModuleHaveOneColumn) {
  const std::string html = page(sample_fault_rows());
  EXPECT_TRUE(contains(html, "<th><span>flow.mpm</span></th>"));
  EXPECT_TRUE(contains(html, "<th><span>solvers, units</span></th>"));
  EXPECT_FALSE(contains(html, "<span>flow.sph</span>")) << "it noticed nothing";
  EXPECT_TRUE(contains(html, "<td class=\"noticed\"><span title=\"flow.mpm: flow.mpm: L2 = 2: FAILS\">−3583</span>"));
  EXPECT_TRUE(contains(html, "<td class=\"hardly\"><span title=\"flow.mpm: \">−5</span></td>"));
  EXPECT_TRUE(contains(html, "<td class=\"noticed\"><span title=\"unit.solvers.A.B: \nunit.solvers.A.C: \">2</span>"));
  EXPECT_TRUE(contains(html, "−inf"));
  EXPECT_TRUE(contains(html, "<td class=\"none\">–</td>"));
}

TEST_F(SeededFaults, EscapeWhatATestSays) {
  EXPECT_FALSE(contains(page("a,<script>,<script>,noticed,,<script>,yes,-1,\"\"\"><script>\"\n"), "<script>"));
  EXPECT_FALSE(contains(page("a,A,f,survived,<script>,<script>,no,1,<script>\n"), "<script>"));
}

}  // namespace
}  // namespace touchstone::reports
