#include "vnv/record/work_precision.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::vnv {
namespace {

WorkPoint point(double cpu, double error, std::string series = "made up") {
  return {"work", std::move(series), "MPM", "run", false, 100, cpu / 1000, error, cpu, 0.9 * cpu, 1.2 * cpu};
}

std::vector<double> times(const std::vector<WorkPoint>& points) {
  std::vector<double> found;
  for (const WorkPoint& p : points) found.push_back(p.cpu);
  return found;
}

TEST(ParetoFront, KeepsWhatNoOtherRunBeatsCheapestFirst) {
  EXPECT_EQ(times(pareto_front({point(10, 1), point(1, 3), point(20, 2), point(100, 0.1), point(2, 3)})),
            (std::vector<double>{1, 10, 100}));
}

TEST(ParetoFront, LeavesOutDearerRunsThatGainLittle) {
  EXPECT_EQ(times(pareto_front({point(1, 1), point(2, 0.99), point(4, 0.98), point(8, 0.94), point(9, 0.93)}, 0.05)),
            (std::vector<double>{1, 8}));
}

TEST(ParetoFront, OfOneTimeKeepsTheSmallerError) {
  const auto front = pareto_front({point(1, 3), point(1, 2)});
  ASSERT_EQ(front.size(), 1u);
  EXPECT_EQ(front[0].error, 2);
}

TEST(ParetoFront, LeavesOutWhatIsNoNumberOrNotPositive) {
  EXPECT_TRUE(pareto_front({point(1, std::nan("")), point(std::nan(""), 1), point(1, 0), point(1, INFINITY)}).empty());
}

TEST(TimeToAnError, FollowsAPowerLawExactly) {
  // error = 1 / cpu²
  const std::vector<WorkPoint> runs = {point(1, 1), point(4, 1.0 / 16), point(16, 1.0 / 256)};
  EXPECT_NEAR(time_to_error(runs, 0.25).cpu, 2, 1e-12);
  EXPECT_NEAR(time_to_error(runs, 1.0 / 64).cpu, 8, 1e-12);
}

TEST(TimeToAnError, HasAnIntervalFromTheFastestRepeatBelowToTheSlowestAbove) {
  const TimeToError found = time_to_error({point(1, 1), point(4, 1.0 / 16)}, 0.25);
  EXPECT_NEAR(found.lowest, 0.9, 1e-12);
  EXPECT_NEAR(found.highest, 4.8, 1e-12);
  EXPECT_FALSE(found.at_most);
}

TEST(TimeToAnError, IsAtMostThatOfTheCheapestRunIfThatIsBetterAlready) {
  const TimeToError found = time_to_error({point(1, 1), point(4, 0.1)}, 3);
  EXPECT_TRUE(found.at_most);
  EXPECT_EQ(found.cpu, 1);
  EXPECT_EQ(found.lowest, 0);
}

TEST(TimeToAnError, ThatNoRunReachesIsNone) {
  EXPECT_FALSE(time_to_error({point(1, 1), point(4, 0.1)}, 0.05).is_reached());
  EXPECT_FALSE(time_to_error({}, 1).is_reached());
}

TEST(TimeToAnError, IsNotMisledByADearRunThatIsHardlyBetter) {
  const std::vector<WorkPoint> runs = {point(1, 1), point(4, 1.0 / 16)};
  EXPECT_EQ(time_to_error({runs[0], point(2, 0.999), runs[1]}, 0.5).cpu, time_to_error(runs, 0.5).cpu);
}

TEST(TimeToAnError, IgnoresRunsThatAreBeaten) {
  const std::vector<WorkPoint> front = {point(1, 1), point(4, 1.0 / 16)};
  std::vector<WorkPoint> all = front;
  all.push_back(point(3, 2));
  EXPECT_EQ(time_to_error(all, 0.25).cpu, time_to_error(front, 0.25).cpu);
}

TEST(Ranking, PutsTheSoonestFirstAndWhatFallsShortLast) {
  EXPECT_EQ(ranking({point(1, 50, "poor"), point(9, 0.5, "slow"), point(2, 0.5, "fast"), point(5, 5, "short")}, 1),
            (std::vector<std::string>{"fast", "slow", "short", "poor"}));
}

TEST(TimePerStep, IsTheSmallestAtAParticleNumber) {
  EXPECT_EQ(time_per_step({point(2, 1), point(1, 1)}, 100), 1e-3);
  EXPECT_TRUE(std::isnan(time_per_step({point(2, 1)}, 200)));
}

}  // namespace
}  // namespace touchstone::vnv
