#include "vnv/harness/run_levels.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <csignal>

namespace touchstone::vnv {
namespace run_levels_test {

using ARun = Run;  // inside a test, Run is GoogleTest's

const Case in_half_a_second{.times = {0.5, 1}, .measurements = {}, .methods = {}};

/// A method of two levels whose runs do this.
Method doing(std::function<ARun(const Level&, const Schedule&)> run) {
  return {.name = "made_up",
          .run = std::move(run),
          .levels = {{.name = "coarse", .spacing = 0.2, .acceptance = 0.5, .report = 1},
                     {.name = "fine", .spacing = 0.1, .report = 1}}};
}

ARun ended(const Schedule& when) {
  return {.summary = {.end_time = when.times.back(), .finished = true, .outcome = "finished", .cost = {.steps = 7}}};
}

TEST(RunLevels, RunsThoseOfTheSuiteUntilItsTime) {
  const Method method = doing([](const Level&, const Schedule& when) { return ended(when); });
  const auto few = run_levels("case", in_half_a_second, method, Suite::acceptance);
  ASSERT_EQ(few.size(), 1u);
  EXPECT_EQ(few[0].summary.level, "coarse");
  EXPECT_EQ(few[0].summary.end_time, 0.5);
  EXPECT_EQ(run_levels("case", in_half_a_second, method, Suite::report).size(), 2u);
}

TEST(RunLevels, RepeatsShortRunsWhereCostIsShown) {
  const Method method = doing([](const Level&, const Schedule& when) { return ended(when); });
  Case declared = in_half_a_second;
  declared.repeats = {.budget = 10, .most = 3, .longest = 10};
  EXPECT_EQ(run_levels("case", declared, method, Suite::report)[1].summary.cost.repeats, 3);
  EXPECT_EQ(run_levels("case", declared, method, Suite::acceptance)[0].summary.cost.repeats, 1);
}

TEST(RunLevels, ChargeTheHarnessWithTheProcessAndNotWithTheSteps) {
  const Method method = doing([](const Level&, const Schedule& when) {
    ARun run = ended(when);
    const StopWatch watch;
    while (watch.seconds() < 0.2) {
    }
    return run;
  });
  const auto runs = run_levels("case", in_half_a_second, method, Suite::acceptance);
  EXPECT_GT(runs[0].summary.cost.harness, 0);
  EXPECT_LT(runs[0].summary.cost.harness, 0.1);
  EXPECT_GT(runs[0].summary.cost.peak_memory, 1e5);
}

TEST(RunLevels, LeavesARunThatDidNotFinishWhereOneDied) {
  const Method method = doing([](const Level& level, const Schedule& when) {
    if (level.name == "fine") raise(SIGKILL);
    return ended(when);
  });
  const auto runs = run_levels("case", in_half_a_second, method, Suite::report);
  EXPECT_TRUE(runs[0].summary.finished);
  EXPECT_FALSE(runs[1].summary.finished);
  EXPECT_NE(runs[1].summary.outcome.find("died of signal 9"), std::string::npos) << runs[1].summary.outcome;
}

TEST(RunLevels, PassesOnThatInputIsRefused) {
  const Method method = doing([](const Level&, const Schedule&) -> ARun { throw std::invalid_argument("spacing"); });
  EXPECT_THROW(run_levels("case", in_half_a_second, method, Suite::report), std::invalid_argument);
}

/// A method of error against run time whose runs take as long as they have particles and steps.
Method taking_its_time() {
  Method method = doing([](const Level& level, const Schedule& when) {
    const double cpu = 0.003 / (level.spacing * level.spacing * level.time_step);
    const CostMeter meter;
    volatile int counted = 0;
    while (meter.read().cpu < cpu)
      for (int k = 0; k < 10000; ++k) counted = counted + 1;  // in user time, which reading the clock is not
    ARun run = ended(when);
    run.summary.cost.cpu = cpu;
    return run;
  });
  method.levels.clear();
  for (const double spacing : {0.1, 0.5, 0.25, 1.0})
    method.levels.push_back({.name = fmt::format("{:g}", spacing), .spacing = spacing, .time_step = 1, .work = 1});
  return method;
}

TEST(RunLevels, OfErrorAgainstRunTimeTakesTheCheapestFirstAndEndsWithinItsBudget) {
  Case declared = in_half_a_second;
  declared.work_budget = 0.15;
  declared.repeats.budget = 0;
  std::vector<std::string> names;
  for (const ARun& run : run_levels("case", declared, taking_its_time(), Suite::work))
    names.push_back(run.summary.level);
  EXPECT_EQ(names, (std::vector<std::string>{"1", "0.5", "0.25"})) << "the next would take 0.3 s";
}

TEST(RunLevels, OfErrorAgainstRunTimeRefinesWhatIsNotClearlyBeatenAtItsCost) {
  Method method = taking_its_time();
  method.levels.clear();
  for (const double spacing : {1.0, 0.5})
    for (const char* combination : {"good", "fair", "poor"})
      method.levels.push_back({.name = fmt::format("{} {:g}", combination, spacing),
                               .spacing = spacing,
                               .time_step = combination == std::string("good") ? 3.0 : 1.0,
                               .work = 1,
                               .combination = combination});
  Case declared = in_half_a_second;
  declared.repeats.budget = 0;
  declared.error_of_work = [](const Level& level, const ARun&) {
    return level.combination == "good" ? 1 : level.combination == "fair" ? 1.4 : 1.6;
  };
  std::vector<std::string> fine;
  for (const ARun& run : run_levels("case", declared, method, Suite::work))
    if (run.summary.spacing == 0.5) fine.push_back(run.summary.level);
  EXPECT_EQ(fine, (std::vector<std::string>{"good 0.5", "fair 0.5"}));
}

TEST(RunLevels, OfErrorAgainstRunTimeLeavesOutWhatAMethodRefuses) {
  Method method = taking_its_time();
  method.time_step = [](const Level& level) { return level.time_step; };
  method.solver = [](const Level& level, double) -> Simulation { throw std::invalid_argument(level.name); };
  EXPECT_TRUE(run_levels("case", in_half_a_second, method, Suite::work).empty());
}

TEST(ALevelOfAnySpacing, HasCellsAsTheLevelOfNearestSpacing) {
  Method method{.levels = {{.name = "M1", .spacing = 0.1, .cell = 0.1}, {.name = "M2", .spacing = 0.05, .cell = 0.1}}};
  EXPECT_NEAR(level_at(method, 0.2).cell, 0.2, 1e-15);
  EXPECT_NEAR(level_at(method, 0.02).cell, 0.04, 1e-15);
  method.levels = {{.name = "S1", .spacing = 0.1}};
  EXPECT_TRUE(std::isnan(level_at(method, 0.1).cell)) << "a method without cells";
}

}  // namespace run_levels_test
}  // namespace touchstone::vnv
