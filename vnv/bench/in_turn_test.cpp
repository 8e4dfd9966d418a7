#include "vnv/bench/in_turn.hpp"

#include <gtest/gtest.h>

namespace touchstone::bench {
namespace {

double made_up_time = 0;  // s

const Effort effort{.rounds = 5, .seconds = 10, .clock = [] { return made_up_time; }};

Work lasting(double seconds) {
  return [seconds] { made_up_time += seconds; };
}

TEST(TimeInTurn, FindsTheTimeOfACallAndRatios) {
  const Times times = time_in_turn({lasting(1), lasting(4)}, effort);
  EXPECT_NEAR(times.of(0), 1, 1e-12);
  EXPECT_NEAR(times.ratio(1, 0), 4, 1e-12);
  EXPECT_NEAR(times.spread(1, 0), 0, 1e-12);
}

TEST(TimeInTurn, ForgivesARoundInWhichOneWorkWasHeldUp) {
  int calls = 0;
  const Work held_up = [&calls] { made_up_time += ++calls == 25 ? 1000 : 1; };
  EXPECT_NEAR(time_in_turn({held_up, lasting(2)}, effort).ratio(1, 0), 2, 1e-12);
}

TEST(TimeInTurn, ForgivesAMachineThatSlowsDown) {
  double speed = 1;
  const auto slowing = [&speed](double seconds) -> Work {
    return [&speed, seconds] { made_up_time += seconds * (speed *= 1.0001); };
  };
  EXPECT_NEAR(time_in_turn({slowing(1), slowing(3)}, effort).ratio(1, 0), 3, 0.01);
}

TEST(TimeInTurn, CountsTheCpuTimeOfThisProcess) {
  const double start = cpu_time();
  volatile double x = 0;
  while (cpu_time() == start) x = x + 1;
  EXPECT_GT(cpu_time(), start);
}

}  // namespace
}  // namespace touchstone::bench
