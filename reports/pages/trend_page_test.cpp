/// Which of several nights, values and curves a page names, where each is another.

#include "reports/pages/pages.hpp"

#include "reports/testing.hpp"

#include <gtest/gtest.h>

namespace touchstone::reports {
namespace trend_page_test {

const std::string l2 = "L2 v_x [%]";

NightVerdict judged(const std::string& level, double spacing, double time, double value) {
  return {"flow", "mpm", level, spacing, time, l2, "theory: so", value, std::nullopt, 100, 0.5, vnv::Outcome::holds};
}

/// Five nights. The finest error at the last time doubles in the third and falls to a tenth in the fifth, in which the
/// coarser one grows by a half and another method's error by a fifth.
History nights() {
  History history;
  for (int n = 0; n < 5; ++n) {
    Night night;
    night.revision = fmt::format("r{}", n);
    night.finished_at = fmt::format("2026-11-2{}T04:00:00Z", n);
    const double fine = n < 2 ? 1 : n < 4 ? 2 : 0.2, coarse = n < 4 ? 4 : 6, other = n < 4 ? 5 : 6;
    night.verdicts = {judged("M1", 4e-3, 1, coarse), judged("M2", 2e-3, 1, fine), judged("M2", 2e-3, 0.5, 7)};
    night.verdicts.push_back(judged("S1", 4e-3, 1, other));
    night.verdicts.back().method = "sph";
    night.runs = {{.case_name = "flow", .method = "mpm", .level = "M1", .finished = true, .outcome = "", .cpu = 1.5},
                  {.case_name = "flow", .method = "mpm", .level = "M2", .finished = true, .outcome = "", .cpu = 2.25}};
    history.nights.push_back(night);
  }
  return history;
}

Content content_of(const History& history) { return all_pages().at("trend").content({{}, history}); }

/// The places of these words, each behind the one before.
void expect_in_turn(const std::string& text, const std::vector<std::string>& words) {
  std::size_t at = 0;
  for (const std::string& word : words) {
    const std::size_t found = text.find(word, at);
    ASSERT_NE(found, text.npos) << word << " is not behind the others in " << text;
    at = found + word.size();
  }
}

TEST(Trend, ListsTheNewestNightFirstAndOfEachMethodWhatWentFurthest) {
  const std::string html = html_of("trend", content_of(nights()).data);
  expect_in_turn(html, {"5 nights, 2026-11-20 to 2026-11-24: the last one changed 3 values.",
                        "2026-11-24",
                        "<code>r4</code>",
                        "mpm",
                        "M2, 1\u202fs <small>and 1 more</small>",
                        ">2<",
                        ">0.2<",
                        ">0.1<",
                        "2026-11-24",
                        "<code>r4</code>",
                        "sph",
                        ">5<",
                        ">6<",
                        ">1.2<",
                        "2026-11-22",
                        "<code>r2</code>",
                        "mpm",
                        ">1<",
                        ">2<",
                        ">2<"});
  EXPECT_EQ(content_of(nights()).tables.at("trend_steps.csv"),
            "night,revision,case,method,level,time [s],quantity,before,after\n"
            "2026-11-24T04:00:00Z,r4,flow,mpm,M2,1,L2 v_x [%],2,0.2\n"
            "2026-11-24T04:00:00Z,r4,flow,mpm,M1,1,L2 v_x [%],4,6\n"
            "2026-11-24T04:00:00Z,r4,flow,sph,S1,1,L2 v_x [%],5,6\n"
            "2026-11-22T04:00:00Z,r2,flow,mpm,M2,1,L2 v_x [%],1,2\n");
}

TEST(Trend, DrawsTheLastTimeAndTheFinestSpacingWithTheLastValueAndTheLastStep) {
  const std::string html = html_of("trend", content_of(nights()).data);
  expect_in_turn(html, {"data-values=\"1,1,2,2,0.2\"", "M2, 1\u202fs", "<b>0.2</b>", "range 0.2 to 2",
                        "step 2026-11-24, <code>r4</code>", "<h3>sph</h3>", "data-values=\"5,5,5,5,6\""});
  EXPECT_FALSE(contains(html, "data-values=\"4,4,4,4,6\"")) << "coarser";
  EXPECT_FALSE(contains(html, "data-values=\"7,7,7,7,7\"")) << "earlier";
  EXPECT_TRUE(contains(html, "data-values=\"2.25,2.25,2.25,2.25,2.25\"")) << "the dearest run";
  EXPECT_FALSE(contains(html, "data-values=\"1.5,1.5,1.5,1.5,1.5\""));
}

TEST(Trend, ListsAllNightsTheNewestFirstWithTheTimeOfAllTheirRuns) {
  History history = nights();
  history.nights.back().verdicts[0].outcome = vnv::Outcome::fails;
  const std::string html = html_of("trend", content_of(history).data);
  expect_in_turn(html.substr(html.find("Nights.")), {">5<", "2026-11-24T04:00:00Z", "r4", ">3<", ">1<", ">0<", ">3.75<",
                                                     ">1<", "2026-11-20T04:00:00Z", "r0", ">4<", ">0<"});
  EXPECT_TRUE(contains(html, "<p class=\"sum fails\">5 nights"));
}

}  // namespace trend_page_test
}  // namespace touchstone::reports
