#include "vnv/gate/cost.hpp"

#include "vnv/judge/testing.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>

namespace touchstone::gate {
namespace {

TEST(PairedTimes, OfEqualTimesHaveARatioOfOneAndNoSignal) {
  const std::vector<double> zeros(8, 0.0);
  EXPECT_EQ(ratio_of(zeros).estimate, 1);
  EXPECT_EQ(ratio_of(zeros).lowest, 1);
  EXPECT_GE(p_value(zeros), 0.5);
}

TEST(PairedTimes, HaveTheIntervalAndTheProbabilityOfTheTables) {
  // Hollander & Wolfe 1999, table A.4: for n = 6, P(T+ >= 21) = 0.016; for n = 10, P(T+ >= 47) = 0.024.
  const std::vector<double> six = {0.01, 0.02, 0.03, 0.04, 0.05, 0.06};
  EXPECT_DOUBLE_EQ(p_value(six), 1.0 / 64);
  EXPECT_DOUBLE_EQ(ratio_of(six).lowest, std::exp(0.01));
  EXPECT_DOUBLE_EQ(ratio_of(six).highest, std::exp(0.06));
  EXPECT_DOUBLE_EQ(ratio_of(six).estimate, std::exp(0.035));
  const std::vector<double> ten = {-0.01, -0.02, -0.05, 0.03, 0.04, 0.06, 0.07, 0.08, 0.09, 0.1};
  EXPECT_NEAR(p_value(ten), 0.024, 5e-4);
}

TEST(PairedTimes, BelowSixPairsHaveNoInterval) {
  EXPECT_TRUE(std::isnan(ratio_of({0.1, 0.1, 0.1, 0.1, 0.1}).lowest));
  EXPECT_TRUE(std::isnan(ratio_of({}).estimate));
  EXPECT_EQ(log_ratios({1, 0, 2, NAN}, {1, 1, 4, 1}), (std::vector<double>{0, std::log(2.0)}));
}

/// User times as measured here: they vary by 1.7 %, and while a neighbour runs by 2 to 8 % more.
class Machine {
 public:
  Machine(unsigned seed, double share_of_outliers) : random_(seed), share_of_outliers_(share_of_outliers) {}

  double time(double mean) {
    const bool is_disturbed = uniform_(random_) < share_of_outliers_;
    return mean * std::exp(0.017 * normal_(random_)) * (is_disturbed ? 1.02 + 0.06 * uniform_(random_) : 1);
  }
  Timing pairs(const std::string& method, double mean, double slower, long count) {
    Timing timing{"case", method, {}, {}};
    for (long k = 0; k < count; ++k) {
      timing.before.push_back(time(mean));
      timing.after.push_back(time(mean * slower));
    }
    return timing;
  }

 private:
  std::mt19937 random_;
  double share_of_outliers_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
};

struct Counts {
  long worse = 0, better = 0, inconclusive = 0, same = 0;
  long looked_again = 0;
  bool right_row_is_worse = false;
};

/// One gate over many methods, of which the first takes `slower` times as long as before.
Counts gate_once(Machine machine, double slower, long methods = 100) {
  const auto factor = [&](const std::string& method) { return method == "0" ? slower : 1; };
  std::vector<Timing> first;
  for (long k = 0; k < methods; ++k)
    first.push_back(
        machine.pairs(std::to_string(k), 0.1 + 0.05 * static_cast<double>(k), factor(std::to_string(k)), least_pairs));
  Counts counts;
  const auto again = [&](const std::vector<Timing>& doubtful) {
    counts.looked_again = std::ssize(doubtful);
    std::vector<Timing> second;
    for (const Timing& timing : doubtful)
      second.push_back(machine.pairs(timing.method, 1, factor(timing.method), times_the_pairs * least_pairs));
    return second;
  };
  for (const Difference& d : compare_costs(first, again)) {
    counts.worse += d.change == Change::worse;
    counts.better += d.change == Change::better;
    counts.inconclusive += d.change == Change::inconclusive;
    counts.same += d.change == Change::same;
    counts.right_row_is_worse |= d.change == Change::worse && d.method == "0";
  }
  return counts;
}

TEST(Cost, OfABuildAgainstItselfAlarmsAtMostOnceInAHundredGates) {
  for (const double outliers : {0.0, 0.02, 0.08}) {
    long alarms = 0, unsure = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
      const Counts counts = gate_once({seed, outliers}, 1);
      alarms += counts.worse + counts.better > 0;
      unsure += counts.inconclusive > 0;
    }
    EXPECT_LE(alarms, 1) << outliers;
    EXPECT_LE(unsure, 1) << outliers;
  }
}

TEST(Cost, NoticesOneMethodAmongAHundredThatIsATwentiethSlower) {
  for (const double outliers : {0.0, 0.02, 0.08}) {
    long named = 0, alone = 0, passed = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
      const Counts counts = gate_once({seed, outliers}, 1.05);
      named += counts.right_row_is_worse;
      alone += counts.worse == 1;
      passed += counts.worse + counts.inconclusive == 0;
    }
    EXPECT_GE(named, 95) << outliers;
    EXPECT_GE(alone, 95) << outliers;
    EXPECT_LE(passed, 1) << outliers;
  }
}

TEST(Cost, NoticesASlowerMethodAlone) {
  for (unsigned seed = 0; seed < 100; ++seed) EXPECT_TRUE(gate_once({seed, 0.02}, 1.05, 1).right_row_is_worse) << seed;
}

TEST(Cost, SaysTheSameOfOnePerCent) {
  for (unsigned seed = 0; seed < 100; ++seed) EXPECT_EQ(gate_once({seed, 0.02}, 1.01, 1).same, 1) << seed;
}

/// A method that is a tenth slower in each of so many pairs of runs, by chance once in 2^pairs.
Timing slower_in_each(long pairs) {
  Timing timing{"case", std::to_string(pairs), {}, {}};
  for (long k = 0; k < pairs; ++k) {
    timing.before.push_back(1);
    timing.after.push_back(1.1 + 0.001 * static_cast<double>(k));
  }
  return timing;
}

TEST(Cost, IsWorseByTheProbabilityAmongAsManyMethodsAsAreCompared) {
  // Holm (1979): of three methods the smallest p-value has to be below 0.001 / 3, the next below 0.001 / 2, then 0.001.
  const auto changes = [](const std::vector<Timing>& timings) {
    std::vector<Change> found;
    for (const Difference& cost : judge_costs(timings)) found.push_back(cost.change);
    return found;
  };
  const Timing as_before{"case", "mpm", std::vector<double>(10, 1.0), std::vector<double>(10, 1.0)};
  EXPECT_EQ(changes({slower_in_each(10)}), std::vector{Change::worse});
  EXPECT_EQ(changes({as_before, slower_in_each(10), as_before}),
            (std::vector{Change::same, Change::inconclusive, Change::same}));
  EXPECT_EQ(changes({slower_in_each(10), slower_in_each(12), slower_in_each(11)}), std::vector(3, Change::worse));
}

TEST(Cost, OfTooFewRunsIsInconclusive) {
  const auto found = judge_costs({Machine(1, 0).pairs("mpm", 1, 1, 5)});
  EXPECT_EQ(found.front().change, Change::inconclusive);
  EXPECT_NE(found.front().why.find("5 pairs of runs, expected at least 6"), std::string::npos);
}

TEST(Cost, OfAMachineTooNoisyIsInconclusive) {
  Timing noisy{"case", "mpm", {}, {}};
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 0.3);
  for (int k = 0; k < 24; ++k) {
    noisy.before.push_back(std::exp(normal(random)));
    noisy.after.push_back(std::exp(normal(random)));
  }
  EXPECT_EQ(judge_costs({noisy}).front().change, Change::inconclusive);
}

TEST(Cost, OfRunsTooShortToTimeIsUnjudged) {
  const auto found = judge_costs({Machine(1, 0).pairs("mpm", 0.01, 3, 24)});
  EXPECT_EQ(found.front().change, Change::unjudged);
  EXPECT_TRUE(is_settled(Machine(1, 0).pairs("mpm", 0.01, 3, 24)));
}

RC_GTEST_PROP(Cost, KnowsNoUnitOfTimeNoOrderOfMethodsAndNoneOfPairs, ()) {
  using Found = std::map<std::string, std::pair<Change, double>>;  // by method
  const auto judged = [](const std::vector<Timing>& timings) {
    Found found;
    const std::vector<Difference> costs = judge_costs(timings);
    for (std::size_t k = 0; k < costs.size(); ++k)
      found[costs[k].method] = {costs[k].change, ratio_of(log_ratios(timings[k].before, timings[k].after)).estimate};
    return found;
  };
  const auto seed = static_cast<unsigned>(vnv::any_count(0, 1000));
  Machine machine(seed, 0.02);
  std::mt19937_64 random(seed);
  std::vector<Timing> timings;
  for (const double slower : {1.0, 1.2, 0.8, 1.02, 1.05})
    timings.push_back(machine.pairs(fmt::format("{}", slower), 1, slower, 20));
  const Found found = judged(timings);
  RC_ASSERT(found.at("1.2").first == Change::worse);
  RC_ASSERT(found.at("0.8").first == Change::better);
  auto others = timings, backwards = timings;
  std::ranges::shuffle(others, random);
  for (Timing& timing : others) {
    const auto of_pairs = random();
    for (std::vector<double>* times : {&timing.before, &timing.after}) {
      for (double& time : *times) time *= 1024;
      std::ranges::shuffle(*times, std::mt19937_64(of_pairs));
    }
  }
  for (const auto& [method, change] : judged(others)) {
    RC_ASSERT(change.first == found.at(method).first);
    RC_ASSERT(vnv::is_near(change.second, found.at(method).second, 1e-12));
  }
  for (Timing& timing : backwards) std::swap(timing.before, timing.after);
  for (const auto& [method, change] : judged(backwards))
    RC_ASSERT(vnv::is_near(change.second * found.at(method).second, 1, 1e-12));
  RC_ASSERT(judged(backwards).at("1.2").first == Change::better);
  RC_ASSERT(judged(backwards).at("0.8").first == Change::worse);
}

}  // namespace
}  // namespace touchstone::gate
