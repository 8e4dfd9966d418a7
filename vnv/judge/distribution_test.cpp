#include "vnv/judge/distribution.hpp"

#include "vnv/judge/testing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

/// So many values of a normal distribution, by the method of Box & Muller.
std::vector<double> normal(int seed, double mean, double deviation, int count = 16) {
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
  std::vector<double> sample;
  for (int k = 0; k < count; ++k)
    sample.push_back(mean + deviation * std::sqrt(-2 * std::log(uniform())) * std::cos(6.283185307179586 * uniform()));
  return sample;
}

TEST(Quantile, LiesBetweenTheMembers) {
  EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(quantile({3, 1, 2}, 0), 1);
  EXPECT_EQ(quantile({3, 1, 2}, 1), 3);
  EXPECT_EQ(quantile({0, 10}, 0.25), 2.5);
  EXPECT_EQ(quantile({7}, 0.3), 7);
  EXPECT_THROW(quantile({}, 0.5), std::invalid_argument);
  EXPECT_THROW(quantile({1}, 1.5), std::invalid_argument);
}

TEST(WassersteinDistance, IsHowFarASampleIsMoved) {
  EXPECT_DOUBLE_EQ(wasserstein_distance({1, 2, 4}, {3, 4, 6}), 2);
  EXPECT_DOUBLE_EQ(wasserstein_distance({1, 3}, {2}), 1);
  EXPECT_DOUBLE_EQ(wasserstein_distance({0, 0, 0, 1}, {0, 1}), 0.25);
  EXPECT_EQ(wasserstein_distance({5, 1, 3}, {1, 3, 5}), 0);
}

TEST(WassersteinDistance, IsNoneWhereThereIsNoNumber) {
  EXPECT_TRUE(std::isnan(wasserstein_distance({}, {1})));
  EXPECT_TRUE(std::isnan(wasserstein_distance({1}, {std::numeric_limits<double>::infinity()})));
  EXPECT_EQ(p_value({1}, {std::nan("")}), 0);
}

TEST(MedianOfAnEnsemble, IsInsideAnExperimentsPercentilesOrNot) {
  EXPECT_TRUE(median_is_inside({1, 5, 9}, 5, 6)) << "edges are inside";
  EXPECT_FALSE(median_is_inside({1, 5, 9}, 5.1, 6));
  EXPECT_TRUE(median_is_inside({1, 5, 6, 9}, 5.4, 5.6));
  EXPECT_FALSE(median_is_inside({1, 5, 9}, 4, 4.9));
  EXPECT_FALSE(median_is_inside({1, 5, 6, 7, std::nan("")}, 0, 9));
  EXPECT_FALSE(median_is_inside({}, 0, 9));
}

TEST(ChanceOfBeingSoUnlike, IsExactForSamplesOfWhichAllDealsAreKnown) {
  // Of the 20 ways to deal six values, two are as unlike as this one.
  EXPECT_NEAR(p_value({1, 2, 3}, {11, 12, 13}), 0.1, 0.005);
  EXPECT_NEAR(p_value({1, 2, 4}, {3, 5, 6}), 4.0 / 20, 0.02);
  EXPECT_NEAR(p_value({1, 8, 9}, {2, 3, 4}), 12.0 / 20, 0.02);
  EXPECT_EQ(p_value({1, 1}, {1, 1}), 1);
}

TEST(ChanceOfBeingSoUnlike, CountsEqualValuesOnce) {
  EXPECT_EQ(p_value({1, 1, 2}, {1, 1, 2}), 1);
  EXPECT_NEAR(p_value({1, 1, 1}, {2, 2, 2}), 0.1, 0.005);
}

TEST(ChanceOfBeingSoUnlike, IsEvenAmongSamplesOfOneDistribution) {
  int below_a_tenth = 0, below_a_hundredth = 0;
  for (int k = 0; k < 400; ++k) {
    const double chance = p_value(normal(2 * k, 1, 0.3), normal(2 * k + 1, 1, 0.3), 999);
    below_a_tenth += chance <= 0.1;
    below_a_hundredth += chance <= 0.01;
  }
  EXPECT_NEAR(below_a_tenth, 40, 18);  // three standard deviations
  EXPECT_LE(below_a_hundredth, 10);
}

TEST(ChanceOfBeingSoUnlike, IsSmallForAnotherMeanAndForAnotherSpread) {
  EXPECT_LT(p_value(normal(1, 1, 0.3), normal(2, 1.6, 0.3)), 1e-3);
  EXPECT_LT(p_value(normal(1, 1, 0.3), normal(2, 1, 3)), 1e-2);  // harder to tell
}

std::vector<double> in_another_unit(std::vector<double> sample, double unit, double zero) {
  for (double& value : sample) value = unit * value + zero;
  return sample;
}

RC_GTEST_PROP(TwoSamples, AreAsUnlikeInAnyUnitFromAnyZeroAndInAnyOrder, ()) {
  const auto a = any_numbers(any_count(2, 8), 0, 4), b = any_numbers(any_count(2, 12), 1, 5);
  std::mt19937_64 random(any_count(0, 1000));
  const auto changed = [&](const std::vector<double>& sample) {
    auto other = in_another_unit(sample, 1024, 4096);  // no digit changes
    std::shuffle(other.begin(), other.end(), random);
    return other;
  };
  const double p = p_value(a, b, 2000);
  RC_ASSERT(p_value(changed(a), changed(b), 2000) == p);
  RC_ASSERT(is_near(p_value(b, a, 2000), p, 0.08));  // dealt at random, 2000 times: five deviations
}

RC_GTEST_PROP(DistancesOfTwoSamples, AreInTheirUnitAndKnowNoZeroNoOrderAndNoRepetition, ()) {
  const auto a = any_numbers(any_count(1, 12), 0, 10), b = any_numbers(any_count(1, 12), 5, -5);
  std::mt19937_64 random(any_count(0, 1000));
  const double unit = -any_unit(6), zero = unit * (any_between(0, 20) - 10);
  const auto changed = [&](const std::vector<double>& sample) {  // mirrored, each twice
    auto other = in_another_unit(sample, unit, zero);
    other.insert(other.end(), other.begin(), other.end());
    std::shuffle(other.begin(), other.end(), random);
    return other;
  };
  const double moved = wasserstein_distance(a, b);
  RC_ASSERT(is_near(wasserstein_distance(changed(b), changed(a)), -unit * moved, -unit * 1e-12 * (1 + moved)));
  RC_ASSERT(is_near(wasserstein_distance(a, in_another_unit(a, 1, zero / unit)), std::abs(zero / unit), 1e-12));
  const double fraction = any_between(0, 1);
  RC_ASSERT(is_near(quantile(in_another_unit(a, unit, zero), 1 - fraction), unit * quantile(a, fraction) + zero,
                    -unit * 1e-10));
}

TEST(SampleAgainstQuantiles, HasTheDistanceAndTheChanceOfCoins) {
  const auto both_below = against_quantiles({1, 2}, {3}, {0.5});
  EXPECT_EQ(both_below.distance, 0.5);
  EXPECT_NEAR(both_below.p_value, 0.5, 1e-12) << "two coins alike";
  EXPECT_NEAR(against_quantiles({1, 4}, {3}, {0.5}).p_value, 1, 1e-12);
  const auto all_above = against_quantiles({5, 5, 5, 5}, {1, 2, 3}, {0.025, 0.5, 0.975});
  EXPECT_EQ(all_above.distance, 0.975);
  EXPECT_NEAR(all_above.p_value, 2 * std::pow(0.025, 4), 1e-12) << "all above, or all below";
}

TEST(SampleAgainstQuantiles, IsSeldomUnlikeItsOwnDistribution) {
  int below_a_tenth = 0;
  for (int k = 0; k < 400; ++k)
    below_a_tenth +=
        against_quantiles(normal(k, 1, 0.5, 16), {1 - 0.98, 1, 1 + 0.98}, {0.025, 0.5, 0.975}).p_value <= 0.1;
  EXPECT_LE(below_a_tenth, 58) << "40 and three standard deviations; fewer, for counts are whole numbers";
  EXPECT_GE(below_a_tenth, 8);
  EXPECT_LT(against_quantiles(normal(1, 2, 0.5, 16), {1 - 0.98, 1, 1 + 0.98}, {0.025, 0.5, 0.975}).p_value, 1e-4);
}

TEST(SampleAgainstQuantiles, IsNoNumberOfWhatIsNone) {
  EXPECT_TRUE(std::isnan(against_quantiles({}, {1}, {0.5}).p_value));
  EXPECT_TRUE(std::isnan(against_quantiles({NAN}, {1}, {0.5}).distance));
  EXPECT_THROW(against_quantiles({1}, {1, 2}, {0.5}), std::invalid_argument);
  EXPECT_THROW(against_quantiles({1}, {2, 1}, {0.1, 0.5}), std::invalid_argument);
  EXPECT_THROW(against_quantiles({1}, {1}, {1}), std::invalid_argument);
}

TEST(MedianComparison, ShowsAModelErrorBeyondTheUncertaintyOfBothMedians) {
  const std::vector<double> members{70, 72, 74, 76, 78};  // deviation sqrt(10)
  const MedianComparison found = compare_median(members, 46.4, 13.2, 100);
  EXPECT_DOUBLE_EQ(found.error, 27.6);
  EXPECT_NEAR(found.uncertainty, 1.2533141373155 * std::hypot(1.32, std::sqrt(2.0)), 1e-12);
  EXPECT_TRUE(found.shows_model_error());
  EXPECT_FALSE(compare_median(members, 71, 13.2, 100).shows_model_error());
  EXPECT_FALSE(compare_median({100}, 50, 1, 100).shows_model_error()) << "one run shows nothing";
  EXPECT_TRUE(compare_median({1, 2, NAN}, 2, 1, 100).shows_model_error()) << "what is no number is no agreement";
}

}  // namespace
}  // namespace touchstone::vnv
