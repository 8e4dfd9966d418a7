#include "vnv/run/cost.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::vnv {
namespace {

Cost run_of(double cpu) {
  Cost cost;
  cost.steps = 10;
  cost.particles = 4;
  cost.cpu = cost.cpu_lowest = cost.cpu_highest = cpu;
  cost.wall = 2 * cpu;
  return cost;
}

TEST(CostOfRepeats, IsTheMedianWithTheSpan) {
  const Cost cost = cost_of_repeats({run_of(3), run_of(1), run_of(9)});
  EXPECT_EQ(cost.repeats, 3);
  EXPECT_EQ(cost.cpu, 3);
  EXPECT_EQ(cost.wall, 6);
  EXPECT_EQ(cost.cpu_lowest, 1);
  EXPECT_EQ(cost.cpu_highest, 9);
  EXPECT_EQ(cost.steps, 10);
}

TEST(CostOfRepeats, OfAnEvenNumberIsBetweenTheMiddleTwo) {
  EXPECT_EQ(cost_of_repeats({run_of(1), run_of(2), run_of(4), run_of(9)}).cpu, 3);
}

TEST(CostMeter, CountsTheTimeOfThisProcessAndNotThatOfAPause) {
  const CostMeter meter;
  volatile double sum = 0;
  for (const StopWatch watch; watch.seconds() < 0.02;) sum = sum + 1;
  const Cost cost = meter.read();
  EXPECT_GT(cost.cpu, 0);
  EXPECT_LE(cost.cpu, cost.wall * 1.01 + 0.011);  // a system may count in ticks of 10 ms
  EXPECT_GE(cost.wall, 0.02);
}

TEST(Cost, IsSpreadOverParticlesAndSteps) {
  EXPECT_DOUBLE_EQ(run_of(2).per_particle_step(), 0.05);
  EXPECT_DOUBLE_EQ(run_of(2).particle_steps_per_second(), 20);
  Cost without_steps = run_of(2);
  without_steps.steps = 0;
  EXPECT_TRUE(std::isnan(without_steps.per_particle_step())) << "of another code, which counts none";
}

}  // namespace
}  // namespace touchstone::vnv
