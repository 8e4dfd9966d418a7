#include "reports/compare/series.hpp"

#include "reports/figures/sparkline.hpp"
#include "reports/testing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace touchstone::reports {
namespace {

/// The nights at which a series steps.
std::vector<std::size_t> steps_of(const std::vector<double>& values, Series::Kind kind = Series::Kind::error,
                                  std::optional<double> tolerance = std::nullopt, std::vector<bool> starts_anew = {}) {
  Series series;
  series.kind = kind;
  series.tolerance = tolerance;
  for (const double value : values) series.points.push_back({true, value, false});
  starts_anew.resize(values.size());
  mark_steps(series, starts_anew);
  std::vector<std::size_t> nights;
  for (const Step& step : series.steps) nights.push_back(step.night);
  return nights;
}
using Nights = std::vector<std::size_t>;

TEST(Steps, AreWhereAValueLeavesItsLevelAndNotWhereItStays) {
  EXPECT_EQ(steps_of({1, 1, 1, 1.5, 1.5, 1}), (Nights{3, 5}));
  EXPECT_EQ(steps_of({1, 1.005, 0.995, 1}), Nights{});
}

TEST(Steps, AreBeyondTheToleranceOfTheBaseline) {
  EXPECT_EQ(steps_of({1, 1.005}, Series::Kind::error, 1e-6), Nights{1});
  EXPECT_EQ(steps_of({1, 1.2}, Series::Kind::error, 0.3), Nights{});
}

TEST(Steps, FindASlowDrift) {
  std::vector<double> values;
  for (int night = 0; night < 12; ++night) values.push_back(1 + 0.004 * night);
  EXPECT_FALSE(steps_of(values).empty());
}

TEST(Steps, AreNotMadeOfNoiseThatIsKnown) {
  EXPECT_EQ(steps_of({1, 1.007, 0.997, 1.006, 0.999, 1.015, 0.985}), Nights{});
}

TEST(Steps, AreMoreThanFourStandardDeviationsOfTheNoiseAway) {
  // Differences of 0.008 from night to night: a standard deviation of 1.4826 / sqrt(2) 0.008 = 0.0084, about 1.004.
  EXPECT_EQ(steps_of({1, 1.008, 1, 1.008, 1, 1.008, 1.034}), Nights{});
  EXPECT_EQ(steps_of({1, 1.008, 1, 1.008, 1, 1.008, 1.044}), Nights{6});
}

TEST(Steps, AreWhereAValueCeasesToBeANumber) {
  EXPECT_EQ(steps_of({1, vnv::not_a_number, vnv::not_a_number, 1}), (Nights{1, 3}));
  EXPECT_EQ(steps_of({INFINITY, INFINITY, 1}), Nights{2});
}

TEST(Steps, AreNoRoundingOfZero) { EXPECT_EQ(steps_of({0, 1e-15, -1e-15}), Nights{}); }

TEST(Steps, OfACostStayForTwoNights) {
  const auto cost = Series::Kind::cost;
  EXPECT_EQ(steps_of({10, 10, 20, 10, 10}, cost), Nights{});
  EXPECT_EQ(steps_of({10, 10, 20, 20, 20}, cost), Nights{2});
  EXPECT_EQ(steps_of({10, 10, 20, 5, 10}, cost), Nights{});
  EXPECT_EQ(steps_of({10, 10.5, 9.6, 10.8}, cost), Nights{});
}

TEST(Steps, OfACostAreConfirmedByTheNextNightThatHasAValue) {
  Series series;
  series.kind = Series::Kind::cost;
  series.points = {{true, 10, false}, {true, 10, false}, {true, 20, false}, {}, {true, 20, false}};
  mark_steps(series, std::vector<bool>(5));
  ASSERT_EQ(series.steps.size(), 1u);
  EXPECT_EQ(series.steps[0].night, 2u);
}

TEST(Steps, OfACostAreNotMadeByAnotherMachine) {
  EXPECT_EQ(steps_of({10, 10, 20, 20}, Series::Kind::cost, std::nullopt, {false, false, true, false}), Nights{});
  EXPECT_EQ(steps_of({1, 1, 2, 2}, Series::Kind::error, std::nullopt, {false, false, true, false}), Nights{2});
}

TEST(Steps, OfACostAreNotMadeByAnotherMachineThatRanOneMethod) {
  Series series;
  series.kind = Series::Kind::cost;
  series.points = {{true, 10, false, "a"}, {true, 10, false, "a"}, {true, 20, false, "b"}, {true, 20, false, "b"}};
  mark_steps(series, std::vector<bool>(4));
  EXPECT_TRUE(series.steps.empty());
}

TEST(Steps, KnowWhetherTheyAreOfAnotherMachine) {
  Night night;
  NightRun& run = night.runs.emplace_back();
  run.case_name = "poiseuille";
  run.method = "mpm";
  run.machine = "a";
  night.errors = {{"poiseuille", "mpm", "M1", 1, 1, "L2 v_x [%]", 1}};
  std::vector<Night> nights(3, night);
  nights[1].runs.clear();
  nights[1].errors.clear();
  nights[2].errors[0].value = 2;
  const auto step_of = [&] {
    const std::vector<Series> all = series_of(nights);
    return night_on_another_machine(all.at(0), all[0].steps.at(0));
  };
  EXPECT_EQ(step_of(), std::nullopt);
  nights[2].runs[0].machine = "b";
  EXPECT_EQ(step_of(), 0u);
}

TEST(Steps, AreWhereAClaimBeginsToFail) {
  Series series;
  series.points = {{true, 1, false}, {true, 1.001, true}, {true, 1.001, true}};
  mark_steps(series, {false, false, false});
  ASSERT_EQ(series.steps.size(), 1u);
  EXPECT_EQ(series.steps[0].night, 1u);
}

TEST(Steps, PassOverANightThatDidNotRun) {
  Series series;
  series.points = {{true, 1, false}, {}, {true, 1, false}, {true, 2, false}};
  mark_steps(series, {false, false, false, false});
  ASSERT_EQ(series.steps.size(), 1u);
  EXPECT_EQ(series.steps[0].before, 1);
  EXPECT_EQ(series.steps[0].after, 2);
}

/// A night in which an error is judged by a baseline and by theory, and another by nobody.
Night judged_night(double value) {
  Night night;
  night.errors = {{"flow", "mpm", "M1", 2e-4, 1, "L2 v_x [%]", 9}, {"flow", "mpm", "M2", 1e-4, 1, "L2 v_x [%]", value}};
  NightVerdict verdict{"flow", "mpm", "M2", 1e-4, 1, "L2 v_x [%]", "baseline: accepted", value, 1, 3, 0.5};
  night.verdicts = {verdict};
  verdict.author = "theory: second order";
  verdict.lower = std::nullopt;
  night.verdicts.push_back(verdict);
  night.orders = {{"flow", "mpm", "grid", "L2 v_x [%]", 1, 2, 2, INFINITY}};
  night.runs = {{.case_name = "flow", .method = "mpm", .level = "M1", .finished = true, .outcome = "", .cpu = 1},
                {.case_name = "flow", .method = "mpm", .level = "M2", .finished = true, .outcome = "", .cpu = 4}};
  return night;
}

TEST(SeriesOfNights, JoinAValueWithTheClaimsOnIt) {
  const auto all = series_of({judged_night(2), judged_night(2.5)});
  const auto found =
      std::ranges::find_if(all, [](const Series& s) { return s.level == "M2" && s.quantity == "L2 v_x [%]"; });
  ASSERT_NE(found, all.end());
  EXPECT_EQ(found->points[1].value, 2.5);
  EXPECT_EQ(found->tolerance, 1);
  EXPECT_EQ(found->author, "theory: second order");
  EXPECT_EQ(found->steps.size(), 0u);
}

TEST(SeriesOfNights, HaveNoCpuTimeOfRunsThatOccupiedAnotherResource) {
  Night night = judged_night(2);
  for (NightRun& run : night.runs) run.cpu = vnv::not_a_number;
  EXPECT_TRUE(std::ranges::none_of(series_of({night}), [](const Series& s) { return s.quantity == "CPU time [s]"; }));
}

TEST(SeriesOfNights, AreDrawnWhereTheoryJudgesThemAndForTheDearestRun) {
  const auto all = series_of({judged_night(2)});
  std::vector<std::string> drawn;
  for (const Series* series : worth_drawing(all)) drawn.push_back(series->quantity + " " + series->level);
  EXPECT_EQ(drawn, (std::vector<std::string>{"L2 v_x [%] M2", "CPU time [s] M2", "peak memory [MB] M2"}));
}

TEST(Sparkline, BreaksWhereANightHasNoNumberAndMarksSteps) {
  Series series;
  series.points = {{true, 1, false}, {true, 2, true}, {}, {true, vnv::not_a_number, false}, {true, 1, false}};
  series.steps = {{1, 1, 2}};
  const auto drawn = [&](const std::string& kind) {
    for (const SparklinePath& path : sparkline(series))
      if (path.kind == kind) return path.d;
    return std::string("nothing");
  };
  EXPECT_EQ(drawn("line"), "M3 27L26.5 3M97 27");
  EXPECT_EQ(drawn("dots fails"), "M26.5 3h0");
  EXPECT_NE(drawn("nan"), "nothing");
  EXPECT_EQ(drawn("step"), "M26.5 0V30");
}

TEST(Sparkline, OfNothingAndOfOneNightIsDrawnToo) {
  Series series;
  series.points = {{}};
  EXPECT_TRUE(sparkline(series).empty());
  series.points = {{true, 5, false}};
  EXPECT_EQ(sparkline(series).back().d, "M50 15h0");
}

}  // namespace
}  // namespace touchstone::reports
