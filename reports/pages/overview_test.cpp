#include "reports/pages/pages.hpp"

#include "reports/testing.hpp"

#include <gtest/gtest.h>

namespace touchstone::reports {
namespace overview_test {

/// A method that is as wrong as accepted, by so much at 1 s in its finest run.
vnv::Record wrong_by(const std::string& method, double error) {
  vnv::Record record = sample_record(method);
  record.verdicts[0].method = method;
  record.verdicts[0].author = "baseline: as measured";
  const vnv::Quantity l2{"L2 v_x", "%", vnv::Kind::norm};
  record.values = {{"M1", 4e-3, 1, l2, 3 * error}, {"M2", 2e-3, 1, l2, error}, {"M2", 2e-3, 0.5, l2, error / 3}};
  return record;
}

TEST(Front, NamesTheMethodsThatAreFarthestOffByTheirFinestRunAtTheirEnd) {
  std::vector<CaseRecords> cases{{"poiseuille", {}}, {"couette", {}}};
  for (int k = 0; k < 9; ++k) {
    cases[k % 2].records.push_back(wrong_by(fmt::format("m{}", k), 20 + (5 * k) % 9));
    cases[k % 2].records.back().case_name = cases[k % 2].name;
  }
  const std::string html = index_page(cases, {});
  std::size_t at = html.find("as last accepted: 9 methods, the farthest:");
  ASSERT_NE(at, html.npos) << html;
  for (int error = 28; error > 20; --error) {
    at = html.find(fmt::format(" {}\u202f% in <a href", error), at);
    ASSERT_NE(at, html.npos) << error << html;
  }
  EXPECT_FALSE(contains(html, " 20\u202f% in <a href")) << "the ninth";
}

TEST(Front, ShowsTheWorkDiagramOfPoiseuilleFlowOrElseTheOneWithMostRuns) {
  const auto with_work = [](const std::string& name, int runs) {
    vnv::Record record = sample_record();
    record.case_name = name;
    record.diagrams = {{"work", "Work", "", {"L2 v_x", "%"}, {1}, 1}};
    for (int k = 0; k < runs; ++k)
      record.work.push_back({.diagram = "work",
                             .series = "mpm",
                             .run = fmt::format("M{}", k),
                             .error = 1.0 / (k + 1),
                             .cpu = 2.0 * (k + 1)});
    return CaseRecords{name, {record}};
  };
  const auto shown = [](const std::vector<CaseRecords>& cases) {
    const std::string html = index_page(cases, {});
    return html.substr(html.find("<img src=\"") + 10, html.find("/work.svg") - html.find("<img src=\"") - 10);
  };
  EXPECT_EQ(shown({with_work("couette", 2), with_work("cavity", 4), with_work("shear_wave", 3)}), "cavity");
  EXPECT_EQ(shown({with_work("couette", 2), with_work("cavity", 4), with_work("poiseuille", 1)}), "poiseuille");
}

TEST(Front, HasARowOfEachMethodBesideItsFlow) {
  const std::string html = index_page({{"poiseuille", {wrong_by("mpm", 20), wrong_by("sph", 30)}}}, {});
  const std::size_t at = html.find("<tr><td class=\"flow\" rowspan=\"2\">");
  ASSERT_NE(at, html.npos) << html;
  EXPECT_LT(at, html.find("<td>mpm</td>"));
  EXPECT_TRUE(contains(html, "<tr><td>sph</td>"));
}

}  // namespace overview_test
}  // namespace touchstone::reports
