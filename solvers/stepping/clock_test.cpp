#include "solvers/stepping/clock.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone {
namespace {

struct Ticking : Clock {
  explicit Ticking(double time_step) : Clock("ticking", time_step) {}
  Ticking& after(int steps) {
    for (int k = 0; k < steps; ++k) tick();
    return *this;
  }
};

TEST(Clock, MultipliesWhereNobodyChangesTheStep) { EXPECT_EQ(Ticking(0.1).after(3).time(), 3 * 0.1); }

TEST(Clock, GoesOnInStepsOfAnotherLength) {
  Ticking clock(0.1);
  clock.after(10).change_time_step(0.25);
  EXPECT_EQ(clock.time(), 1);
  EXPECT_EQ(clock.after(4).time(), 2);
  EXPECT_EQ(clock.steps(), 14);
  EXPECT_EQ(clock.time_step(), 0.25);
}

TEST(Clock, RefusesAStepThatIsNotPositive) {
  EXPECT_THROW(Ticking(0), std::invalid_argument);
  EXPECT_THROW(Ticking(0.1).change_time_step(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone
