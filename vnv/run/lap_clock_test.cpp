#include "vnv/run/lap_clock.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace touchstone::vnv {
namespace {

/// A solver that does nothing but wait.
struct Waiting {
  int steps = 0;

  void step(const Laps& lap = no_laps) {
    ++steps;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    lap(SubStep::scatter);
    std::this_thread::sleep_for(std::chrono::milliseconds(4));
    lap(SubStep::gather);
  }
};

TEST(LapClock, TellsSubStepsApart) {
  LapClock laps;
  Waiting solver;
  for (int k = 0; k < 3; ++k) laps.step(solver);
  EXPECT_GE(laps.per_step(SubStep::scatter), 1e-3);
  EXPECT_GE(laps.per_step(SubStep::gather), 4e-3);
  EXPECT_EQ(laps.per_step(SubStep::pairs), 0);
  EXPECT_DOUBLE_EQ(laps.per_step(), laps.per_step(SubStep::scatter) + laps.per_step(SubStep::gather));
}

TEST(LapClock, TimesOneStepInSoMany) {
  LapClock laps(4), silent(100);
  Waiting solver;
  silent.step(solver);
  for (int k = 0; k < 8; ++k) laps.step(solver);
  EXPECT_EQ(solver.steps, 9);
  EXPECT_GE(laps.per_step(), 5e-3);  // a mean over the timed steps alone
}

TEST(LapClock, SaysZeroOfNoSteps) {
  EXPECT_EQ(LapClock().per_step(), 0);
  EXPECT_EQ(LapClock().per_step(SubStep::grid), 0);
}

}  // namespace
}  // namespace touchstone::vnv
