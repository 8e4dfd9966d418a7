#include "vnv/studies/run_time.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::vnv {
namespace run_time_test {

const Quantity error{"L2", "%", Kind::norm};
const WorkStudy study{.error = error,
                      .times = {0.1, 1},
                      .length = 1,
                      .cells = {4, 8},
                      .particles = {10},
                      .points = {1, 2},
                      .kernels = {1, 1.5},
                      .steps = {2, 1},
                      .largest_speed = 2,
                      .stiffness = {50, 5},
                      .targets = {1, 0.1}};

/// A method whose step is a 6.73rd of its spacing over the sound speed.
Method made_up(Family family) {
  return {.name = "made_up",
          .family = family,
          .time_step = [](const Level& level) { return level.spacing / (6.73 * level.sound_speed); },
          .levels = {{.name = "M1", .spacing = 0.1, .acceptance = 1}}};
}

Method studied(Family family) {
  return with_work({.times = {1}, .measurements = {}, .methods = {made_up(family)}}, study).methods[0];
}

TEST(WorkStudy, AddsEachCombinationOfWhatAMethodHasOnceAndNoneToOtherSuites) {
  const Method mpm = studied(Family::mpm), sph = studied(Family::sph);
  EXPECT_EQ(mpm.levels.size(), 1u + 2 * 2 * 2 * 2) << "cells, points, sound speeds and steps";
  EXPECT_EQ(sph.levels.size(), 1u + 1 * 2 * 2 * 2) << "particles, kernels, sound speeds and steps";
  EXPECT_EQ(sph.levels[1].name, "10 across, h 1, 0.0002967 s, c 100 m/s");
  for (const Level& level : mpm.levels) EXPECT_EQ(level.until(Suite::work) > 0, level.until(Suite::acceptance) == 0);
}

TEST(WorkStudy, TakesWholeNumbersOfStepsToEachTime) {
  for (const Level& level : studied(Family::mpm).levels)
    if (level.work > 0) {
      EXPECT_NEAR(0.1 / level.time_step, std::round(0.1 / level.time_step), 1e-6) << level.name;
    }
}

TEST(WorkStudy, ComputesAStripOfEightCellsOrAKernelWhereThatIsShorterThanTheScene) {
  WorkStudy of_strip = study;
  of_strip.period = 1.5;
  const auto period = [&](Family family, const std::string& start) {
    const Method method =
        with_work({.times = {1}, .measurements = {}, .methods = {made_up(family)}}, of_strip).methods[0];
    return std::ranges::find_if(method.levels, [&](const Level& l) { return l.name.starts_with(start); })->period;
  };
  EXPECT_EQ(period(Family::mpm, "4 cells"), 1.5);
  EXPECT_EQ(period(Family::mpm, "8 cells, 4"), 1.0);
  EXPECT_DOUBLE_EQ(period(Family::sph, "10 across, h 1,"), 0.4);
  EXPECT_DOUBLE_EQ(period(Family::sph, "10 across, h 1.5"), 0.6);
  for (const Level& level : studied(Family::mpm).levels) EXPECT_TRUE(std::isnan(level.period)) << level.name;
}

/// A run of a level with errors at 0.1 and 1 s, and its CPU time.
void add_run(Results& results, Record& record, const Level& level, double early, double late, double cpu) {
  Run run;
  run.summary = {.level = level.name, .spacing = level.spacing, .end_time = 1, .finished = true, .outcome = "finished"};
  run.summary.cost.cpu = run.summary.cost.cpu_lowest = run.summary.cost.cpu_highest = cpu;
  record.values.push_back({level.name, level.spacing, 0.1, error, early});
  record.values.push_back({level.name, level.spacing, 1, error, late});
  results.runs.push_back(std::move(run));
}

TEST(WorkStudy, CountsTheLargestErrorOfItsTimesByMagnitude) {
  const Method method = studied(Family::mpm);
  Results results{method, Suite::work, {}};
  Record record;
  add_run(results, record, method.levels[1], -3, 0.5, 7);
  const std::vector<WorkPoint> points = work_points(study.diagram(), study.times, results, record);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].error, 3);
  EXPECT_EQ(points[0].cpu, 7);
}

TEST(WorkStudy, CountsARunByTheLargerErrorOfItsOwnAndTheNextFinerOne) {
  const Method method = studied(Family::mpm);
  Results results{method, Suite::work, {}};
  Record record;
  const auto level = [&](const std::string& start, const std::string& combination) {
    return *std::ranges::find_if(
        method.levels, [&](const Level& l) { return l.name.starts_with(start) && l.combination == combination; });
  };
  const std::string same = "1 per cell, step 1, c/U 5";
  add_run(results, record, level("4 cells", same), 0.01, 0.01, 1);
  add_run(results, record, level("8 cells", same), 0.5, 0.5, 8);
  add_run(results, record, level("8 cells", "4 per cell, step 1, c/U 5"), 2, 2, 32);
  std::vector<double> errors;
  for (const WorkPoint& point : work_points(study.diagram(), study.times, results, record))
    errors.push_back(point.error);
  EXPECT_EQ(errors, (std::vector<double>{0.5, 0.5, 2}));
}

TEST(WorkStudy, SaysHowSoftAFluidMayBeForAnErrorAndWhatThatSaves) {
  const Case declared = with_work({.times = {1}, .measurements = {}, .methods = {made_up(Family::mpm)}}, study);
  const Method& method = declared.methods[0];
  Results results{method, Suite::work, {}};
  Record record;
  for (const Level& level : method.levels)
    if (level.sound_speed == 100)
      add_run(results, record, level, 0.05, 0.05, 8);
    else if (level.sound_speed == 10)
      add_run(results, record, level, 0.5, 0.5, 2);
  for (const Plot& plot : declared.plots) plot(results, record);
  ASSERT_EQ(record.tables.size(), 1u);
  EXPECT_EQ(record.tables[0].rows,
            (std::vector<std::vector<Cell>>{{"made_up", "5", "2 at 5, × 4", "50", "8 at 50, × 1"}}));
  Record of_another_suite;
  Results in_acceptance{method, Suite::acceptance, {}};
  for (const Plot& plot : declared.plots) plot(in_acceptance, of_another_suite);
  EXPECT_EQ(of_another_suite, Record{});
}

}  // namespace run_time_test
}  // namespace touchstone::vnv
