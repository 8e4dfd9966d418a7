#include "vnv/measures/steadiness.hpp"

#include "vnv/record/record.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::vnv {
namespace {

/// A run of 10 s whose energy, in the second column, rises fast at first and by 2 % per second in the end.
vnv::Run slowing() {
  vnv::Run run{.summary = {.level = "M1", .spacing = 0.1, .end_time = 10, .finished = true}};
  for (int k = 0; k <= 20; ++k) {
    const double t = 0.5 * k;
    run.history.time.push_back(t);
    run.history.values.push_back({7, t < 8 ? t : 8 * std::exp(0.02 * (t - 8))});
  }
  return run;
}

std::vector<Value> found_in(const vnv::Run& run, double span) {
  const Method method{.name = "mpm"};
  return unsteadiness(1, span)({method, Suite::acceptance, {run}}, {});
}

TEST(Unsteadiness, IsTheChangeOfEnergyAtTheEnd) {
  const std::vector<Value> found = found_in(slowing(), 2);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].level, "M1");
  EXPECT_EQ(found[0].time, 10);
  EXPECT_NEAR(found[0].value, 2, 1e-10);
  EXPECT_GT(found_in(slowing(), 6)[0].value, 5);
}

TEST(Unsteadiness, OfARunThatWasNotWatchedLongEnoughIsNotANumber) {
  EXPECT_TRUE(std::isnan(found_in(slowing(), 0.1)[0].value));
}

TEST(Unsteadiness, OfARunThatDivergedIsNotTold) {
  vnv::Run run = slowing();
  run.summary.finished = false;
  EXPECT_TRUE(found_in(run, 2).empty());
}

}  // namespace
}  // namespace touchstone::vnv
