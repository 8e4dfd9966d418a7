#include "vnv/judge/order.hpp"

#include "vnv/judge/error_law.hpp"
#include "vnv/judge/testing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace touchstone::vnv {
namespace {

const std::vector<double> ladder{0.08, 0.04, 0.02, 0.01, 0.005};  // m

std::vector<double> errors_of(const std::function<double(double)>& law, const std::vector<double>& spacings = ladder) {
  std::vector<double> errors;
  for (const double h : spacings) errors.push_back(law(h));
  return errors;
}

std::vector<double> cut(std::vector<double> values, std::size_t size) {
  values.resize(size);
  return values;
}

TEST(ObservedOrder, OfAPowerLawIsItsExponentWithItsSignAndWithoutDoubt) {
  for (const double p : {1.0, 2.0, -1.0}) {
    const auto found = observe_order(ladder, errors_of([p](double h) { return 0.3 * std::pow(h, p); }));
    EXPECT_NEAR(found.order, p, 1e-12);
    EXPECT_LT(found.half_width, 1e-12) << p;
    ASSERT_EQ(found.pairwise.size(), ladder.size() - 1);
    for (const double pair : found.pairwise) EXPECT_NEAR(pair, p, 1e-12);
  }
}

TEST(ObservedOrder, IsTheSameInAnyUnit) {
  const auto law = [](double h) { return 0.3 * h + 2 * h * h; };
  const auto metres = observe_order(ladder, errors_of(law));
  std::vector<double> millimetres = ladder, percent = errors_of(law);
  for (double& h : millimetres) h *= 1e3;
  for (double& error : percent) error *= 100;
  const auto scaled = observe_order(millimetres, percent);
  EXPECT_NEAR(scaled.order, metres.order, 1e-12);
  EXPECT_NEAR(scaled.half_width, metres.half_width, 1e-12);
}

TEST(ObservedOrder, OfASumOfTwoPowersLiesBetweenThem) {
  const auto found = observe_order(ladder, errors_of([](double h) { return h + 20 * h * h; }));
  EXPECT_GT(found.order, 1.05);
  EXPECT_LT(found.order, 1.95);
}

TEST(ObservedOrder, ShowsAFloorByAFallingTailOfPairs) {
  const auto found = observe_order(ladder, errors_of([](double h) { return h * h + 25e-6; }));
  ASSERT_EQ(found.pairwise.size(), 4u);
  for (std::size_t i = 1; i < found.pairwise.size(); ++i) EXPECT_LT(found.pairwise[i], found.pairwise[i - 1] - 0.01);
  EXPECT_LT(found.order, found.pairwise.front());
  EXPECT_GT(found.order, found.pairwise.back());
}

TEST(ObservedOrder, OfTwoRungsHasNoFiniteInterval) {
  const auto found = observe_order({0.02, 0.01}, {4e-4, 1e-4});
  EXPECT_NEAR(found.order, 2, 1e-12);
  EXPECT_EQ(found.half_width, std::numeric_limits<double>::infinity());
}

TEST(ObservedOrder, OfFewerThanTwoRungsIsNotANumber) {
  for (const std::size_t levels : {0u, 1u}) {
    const auto found = observe_order(cut(ladder, levels), std::vector<double>(levels, 1e-3));
    EXPECT_TRUE(std::isnan(found.order));
    EXPECT_TRUE(std::isnan(found.half_width));
    EXPECT_TRUE(found.pairwise.empty());
  }
}

TEST(ObservedOrder, OfAnErrorWithoutLogarithmIsNotANumber) {
  for (const double bad : {0.0, -1e-3, not_a_number, std::numeric_limits<double>::infinity()}) {
    auto errors = errors_of([](double h) { return h; });
    errors[2] = bad;
    const auto found = observe_order(ladder, errors);
    EXPECT_TRUE(std::isnan(found.order)) << bad;
    EXPECT_TRUE(std::isnan(found.half_width)) << bad;
    EXPECT_TRUE(std::isnan(found.pairwise[1]) && std::isnan(found.pairwise[2])) << bad;
    EXPECT_NEAR(found.pairwise[0], 1, 1e-12) << "the pairs that do not touch it keep their order";
  }
  EXPECT_TRUE(std::isnan(observe_order({0.02, 0.01}, {1e-3, 0}).half_width));
}

TEST(ObservedOrder, RefusesSpacingsThatDoNotFall) {
  EXPECT_THROW(observe_order({0.01, 0.02}, {1, 1}), std::invalid_argument);
  EXPECT_THROW(observe_order({0.02, 0.02}, {1, 1}), std::invalid_argument);
  EXPECT_THROW(observe_order({0.02, 0}, {1, 1}), std::invalid_argument);
  EXPECT_THROW(observe_order({0.02, not_a_number}, {1, 1}), std::invalid_argument);
  EXPECT_THROW(observe_order({std::numeric_limits<double>::infinity(), 0.02}, {1, 1}), std::invalid_argument);
  EXPECT_THROW(observe_order({0.02, 0.01}, {1}), std::invalid_argument);
}

TEST(ObservedOrder, NamesTheSpacingItRefuses) {
  try {
    observe_order({0.02, 0.03}, {1, 1});
    FAIL() << "was accepted";
  } catch (const std::invalid_argument& refused) {
    EXPECT_NE(std::string(refused.what()).find("0.03 m after 0.02 m"), std::string::npos) << refused.what();
  }
}

/// Share of noisy ladders whose interval holds the true order.
double coverage(std::size_t levels) {
  constexpr int repeats = 2000;
  constexpr double order = 2, noise = 0.1;
  std::mt19937_64 generator(20240117);
  std::normal_distribution<double> normal;
  int covered = 0;
  for (int i = 0; i < repeats; ++i) {
    const auto found = observe_order(
        cut(ladder, levels),
        cut(errors_of([&](double h) { return std::pow(h, order) * std::exp(noise * normal(generator)); }), levels));
    covered += std::abs(found.order - order) <= found.half_width;
  }
  return static_cast<double>(covered) / repeats;
}

TEST(ObservedOrder, HasAnIntervalThatHoldsTheTruthNineteenTimesInTwenty) {
  for (const std::size_t levels : {3u, 4u, 5u}) EXPECT_NEAR(coverage(levels), 0.95, 0.015) << levels << " levels";
}

const std::vector<double> long_ladder{0.08, 0.056, 0.04, 0.028, 0.02, 0.014, 0.01};  // m

/// Errors of a law that scatter by a fraction of themselves.
class NoisyErrors {
 public:
  NoisyErrors(std::function<double(double)> law, double noise) : law_(std::move(law)), noise_(noise) {}
  std::vector<double> next(const std::vector<double>& spacings = long_ladder) {
    return errors_of([&](double h) { return law_(h) * std::exp(noise_ * normal_(generator_)); }, spacings);
  }

 private:
  std::function<double(double)> law_;
  double noise_;
  std::mt19937_64 generator_{20261121};
  std::normal_distribution<double> normal_;
};

TEST(AFloor, IsFoundWithTheOrderThatLeadsToIt) {
  const auto found = observe_order(long_ladder, errors_of([](double h) { return 2e-4 + 0.5 * h * h; }, long_ladder));
  EXPECT_NEAR(found.floor, 2e-4, 1e-9);
  EXPECT_NEAR(found.order_to_floor, 2, 1e-5);
  EXPECT_EQ(found.trend, Trend::stalled) << "the finest error is 2.5e-4";
}

TEST(ALawWithAFloor, FeelsTheErrorOfEachLevel) {
  const std::vector<double> exact = errors_of([](double h) { return 2e-4 + 0.5 * h * h; });
  EXPECT_LT(fit_law_with_floor(ladder, exact)->squares, 1e-12);
  for (std::size_t k = 0; k < ladder.size(); ++k) {
    std::vector<double> errors = exact;
    errors[k] *= 1.05;
    EXPECT_GT(fit_law_with_floor(ladder, errors)->squares, 1e-6) << ladder[k];
  }
}

TEST(ALawWithAFloor, NeedsALevelMoreThanItHasParameters) {
  const std::vector<double> exact = errors_of([](double h) { return 2e-4 + 0.5 * h * h; });
  EXPECT_FALSE(fit_law_with_floor(cut(ladder, 3), cut(exact, 3)));
  EXPECT_TRUE(fit_law_with_floor(cut(ladder, 4), cut(exact, 4)));
}

TEST(ALawWithAFloor, IsNoneWhereErrorsRiseFromIt) {
  EXPECT_FALSE(fit_law_with_floor(ladder, errors_of([](double h) { return 1e-3 + 1e-5 / h; })));
}

TEST(AFloor, OfANoisyLadderIsHeldByItsInterval) {
  NoisyErrors noisy([](double h) { return 3e-4 + 0.5 * h * h; }, 0.03);
  constexpr int repeats = 400;
  int found = 0, floor_held = 0, order_held = 0;
  for (int i = 0; i < repeats; ++i) {
    const auto o = observe_order(long_ladder, noisy.next());
    if (std::isnan(o.floor)) continue;
    ++found;
    floor_held += std::abs(o.floor - 3e-4) <= o.floor_half_width;
    order_held += std::abs(o.order_to_floor - 2) <= o.order_to_floor_half_width;
  }
  EXPECT_GT(found, 0.95 * repeats);
  EXPECT_NEAR(static_cast<double>(floor_held) / found, 0.95, 0.03);
  EXPECT_NEAR(static_cast<double>(order_held) / found, 0.95, 0.03);
}

TEST(AFloor, IsSeenWhereThereIsNoneOnceInTwentyTimesAtMost) {
  NoisyErrors noisy([](double h) { return 0.5 * h * h; }, 0.1);
  constexpr int repeats = 1000;
  int seen = 0;
  for (int i = 0; i < repeats; ++i) seen += !std::isnan(observe_order(long_ladder, noisy.next()).floor);
  EXPECT_LE(seen, repeats / 20);
}

TEST(AFloor, IsNoneWhereALineScattersHardlyMore) {
  EXPECT_TRUE(std::isnan(observe_order({0.08, 0.04, 0.02, 0.01}, {1.571, 0.9714, 0.7171, 0.634}).floor));
}

TEST(AFloor, IsNotLookedForWithoutARungToSpare) {
  EXPECT_TRUE(std::isnan(observe_order({0.04, 0.02, 0.01}, {1e-3, 4e-4, 3e-4}).floor));
}

Trend trend_of(const std::function<double(double)>& law, const std::vector<double>& spacings = ladder) {
  return observe_order(spacings, errors_of(law, spacings)).trend;
}

TEST(ATrend, IsToldFromTheLadder) {
  EXPECT_EQ(trend_of([](double h) { return h * h; }), Trend::converging);
  EXPECT_EQ(trend_of([](double h) { return std::sqrt(h); }), Trend::converging);
  EXPECT_EQ(trend_of([](double) { return 0.02; }), Trend::stalled);
  EXPECT_EQ(trend_of([](double h) { return 8e-5 + h * h; }, long_ladder), Trend::converging)
      << "less than half is floor";
  EXPECT_EQ(trend_of([](double h) { return 1 / h; }), Trend::diverging);
}

TEST(ATrend, IsInconclusiveWhereTheLadderDoesNotSay) {
  EXPECT_EQ(observe_order({0.02, 0.01}, {4e-4, 1e-4}).trend, Trend::inconclusive) << "two levels";
  EXPECT_EQ(observe_order({0.04, 0.02, 0.01}, {1e-3, 5e-3, 1e-4}).trend, Trend::inconclusive) << "a jump";
  EXPECT_EQ(observe_order({0.04, 0.02, 0.01}, {1e-3, 0, 1e-4}).trend, Trend::inconclusive) << "no error at all";
}

TEST(ATrend, OfNoiseAloneIsSeldomCalledConvergence) {
  NoisyErrors noisy([](double) { return 0.02; }, 0.1);
  int converging = 0;
  for (int i = 0; i < 400; ++i) converging += observe_order(long_ladder, noisy.next()).trend == Trend::converging;
  EXPECT_LE(converging, 10);
}

TEST(ALadder, IsAsymptoticWhereItsFinestPairsHaveTheOrderOfAll) {
  EXPECT_TRUE(observe_order(ladder, errors_of([](double h) { return h * h; })).asymptotic);
  EXPECT_FALSE(observe_order(ladder, errors_of([](double h) { return h + 20 * h * h; })).asymptotic);
  EXPECT_TRUE(observe_order(long_ladder, errors_of([](double h) { return 3e-5 + h * h; }, long_ladder)).asymptotic)
      << "above its floor";
}

RC_GTEST_PROP(ObservedOrder, OfAnyErrorsKnowsNoUnit, ()) {
  const std::vector<double> spacings = cut(ladder, any_count(2, 5));
  const double p = any_between(0, 6) - 3, metre = any_unit(6), unit = any_unit(6);
  std::vector<double> errors =
      errors_of([&](double h) { return std::exp(any_between(0, 1) - 0.5) * std::pow(h, p); }, spacings);
  const auto found = observe_order(spacings, errors);
  std::vector<double> others = spacings;
  for (double& h : others) h *= metre;
  for (double& e : errors) e *= unit;
  const auto scaled = observe_order(others, errors);
  RC_ASSERT(is_near(scaled.order, found.order, 1e-9));
  if (spacings.size() == 2)
    RC_ASSERT(scaled.half_width == found.half_width);
  else
    RC_ASSERT(is_near(scaled.half_width, found.half_width, 1e-9 * (1 + found.half_width)));
  RC_ASSERT(scaled.trend == found.trend);
  for (std::size_t k = 0; k < found.pairwise.size(); ++k)
    RC_ASSERT(is_near(scaled.pairwise[k], found.pairwise[k], 1e-9));
  for (double& e : errors) e = 1 / e;  // what shrank grows
  RC_ASSERT(is_near(observe_order(spacings, errors).order, -found.order, 1e-9));
}

RC_GTEST_PROP(AFloor, IsInTheUnitOfTheErrorsAndItsOrderInNone, ()) {
  const double p = any_between(2, 1) + any_between(0, 1),
               floor = std::pow(long_ladder.back(), p) * any_between(0.3, 0.9);
  std::vector<double> spacings = long_ladder,
                      errors = errors_of(
                          [&](double h) { return std::exp(any_between(0, 0.04) - 0.02) * (floor + std::pow(h, p)); },
                          spacings);
  const auto found = observe_order(spacings, errors);
  const double metre = any_unit(6), unit = any_unit(6);
  for (double& h : spacings) h *= metre;
  for (double& e : errors) e *= unit;
  const auto scaled = observe_order(spacings, errors);
  RC_ASSERT(std::isnan(scaled.floor) == std::isnan(found.floor));
  if (std::isnan(found.floor)) return;
  RC_ASSERT(is_near(scaled.floor / unit, found.floor, 1e-5 * found.floor));
  RC_ASSERT(is_near(scaled.floor_half_width / unit, found.floor_half_width, 1e-4 * found.floor));
  RC_ASSERT(is_near(scaled.order_to_floor, found.order_to_floor, 1e-5));
  RC_ASSERT(scaled.trend == found.trend);
  RC_ASSERT(scaled.asymptotic == found.asymptotic);
}

}  // namespace
}  // namespace touchstone::vnv
