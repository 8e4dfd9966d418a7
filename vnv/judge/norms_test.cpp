#include "vnv/judge/norms.hpp"

#include "vnv/judge/testing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::vnv {
namespace norms_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::vector<double> truth{3, -1, 4, -1.5, 9};
const std::vector<double> equal(5, 1.0);

std::vector<double> times(double factor, std::vector<double> values) {
  for (double& value : values) value *= factor;
  return values;
}

std::vector<double> with(std::size_t place, double value, std::vector<double> values = truth) {
  values[place] = value;
  return values;
}

template <class Norm>
std::string refusal(Norm norm) {
  try {
    norm();
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "";
}

TEST(Norms, OfTheTruthAreZero) {
  EXPECT_EQ(relative_l2(truth, truth, equal), 0);
  EXPECT_EQ(relative_linf(truth, truth), 0);
}

TEST(Norms, OfAUniformlyScaledTruthAreTheScaling) {
  for (const double factor : {0.0, 0.97, 1.5, -1.0}) {
    EXPECT_NEAR(relative_l2(times(factor, truth), truth, equal), std::abs(1 - factor), 1e-14);
    EXPECT_NEAR(relative_linf(times(factor, truth), truth), std::abs(1 - factor), 1e-14);
  }
}

TEST(Norms, DoNotDependOnTheUnit) {
  const auto numerical = with(1, 0.2);
  EXPECT_NEAR(relative_l2(times(1e-3, numerical), times(1e-3, truth), equal), relative_l2(numerical, truth, equal),
              1e-14);
  EXPECT_NEAR(relative_linf(times(1e-3, numerical), times(1e-3, truth)), relative_linf(numerical, truth), 1e-14);
}

TEST(Norms, GrowInProportionToTheError) {
  EXPECT_NEAR(relative_l2(with(2, 5), truth, equal), 2 * relative_l2(with(2, 4.5), truth, equal), 1e-14);
  EXPECT_NEAR(relative_linf(with(2, 5), truth), 2 * relative_linf(with(2, 4.5), truth), 1e-14);
}

TEST(RelativeL2, CountsAWeightAsThatManyValues) {
  const std::vector<double> numerical{1.1, 2.3}, exact{1, 2}, weights{1, 3};
  const std::vector<double> numerical_often{1.1, 2.3, 2.3, 2.3}, exact_often{1, 2, 2, 2}, ones(4, 1.0);
  EXPECT_NEAR(relative_l2(numerical, exact, weights), relative_l2(numerical_often, exact_often, ones), 1e-14);
}

TEST(RelativeL2, DoesNotSeeAValueWithoutWeight) { EXPECT_EQ(relative_l2(with(3, 100), truth, with(3, 0, equal)), 0); }

TEST(RelativeLinf, SeesOnlyTheWorstValue) {
  EXPECT_EQ(relative_linf(with(0, 5), truth), relative_linf(with(1, -0.5, with(0, 5)), truth));
  EXPECT_LT(relative_l2(with(0, 5), truth, equal), relative_l2(with(1, -0.5, with(0, 5)), truth, equal));
}

TEST(Norms, KeepWhatIsNotANumberWhereverItStands) {
  for (std::size_t place = 0; place < truth.size(); ++place) {
    EXPECT_TRUE(std::isnan(relative_l2(with(place, nan), truth, equal))) << place;
    EXPECT_TRUE(std::isnan(relative_l2(truth, with(place, nan), equal))) << place;
    EXPECT_TRUE(std::isnan(relative_l2(truth, truth, with(place, nan, equal)))) << place;
    EXPECT_TRUE(std::isnan(relative_linf(with(place, nan), truth))) << place;
    EXPECT_TRUE(std::isnan(relative_linf(truth, with(place, nan)))) << place;
  }
}

TEST(Norms, OfAnInfiniteValueAreNotFinite) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(std::isfinite(relative_l2(with(1, infinite), truth, equal)));
  EXPECT_FALSE(std::isfinite(relative_linf(with(1, infinite), truth)));
}

TEST(Norms, RefuseInOneLine) {
  const std::vector<double> none, zeros(5, 0.0), four(4, 1.0);
  const std::vector<std::pair<std::string, std::string>> refusals{
      {refusal([&] { relative_l2(none, none, none); }), "0 numerical values and 0 exact"},
      {refusal([&] { relative_l2(four, truth, equal); }), "4 numerical values and 5 exact"},
      {refusal([&] { relative_l2(truth, truth, four); }), "4 weight values and 5 exact"},
      {refusal([&] { relative_l2(truth, truth, with(2, -1, equal)); }), "weight 2 = -1"},
      {refusal([&] { relative_l2(truth, zeros, equal); }), "all zero"},
      {refusal([&] { relative_l2(truth, truth, zeros); }), "all zero"},
      {refusal([&] { relative_linf(none, none); }), "0 numerical values and 0 exact"},
      {refusal([&] { relative_linf(four, truth); }), "4 numerical values and 5 exact"},
      {refusal([&] { relative_linf(truth, zeros); }), "all zero"},
  };
  for (const auto& [message, expected] : refusals) {
    EXPECT_NE(message.find(expected), std::string::npos) << message << " | " << expected;
    EXPECT_EQ(std::ranges::count(message, '\n'), 0);
  }
}

RC_GTEST_PROP(Norms, OfAnyValuesKnowNoUnitNoOrderAndNoRepetition, ()) {
  const std::size_t count = any_count(1, 40);
  const auto found = any_numbers(count, 0, -2), exact = any_numbers(count, 1, -1), weights = any_numbers(count, 1, 0.1);
  RC_PRE(std::ranges::any_of(exact, [](double value) { return value != 0; }));
  const double l2 = relative_l2(found, exact, weights), linf = relative_linf(found, exact);
  const double unit = any_unit(3);
  RC_ASSERT(is_near(relative_l2(times(-unit, found), times(-unit, exact), times(unit, weights)), l2, 1e-12 * l2));
  RC_ASSERT(is_near(relative_linf(times(-unit, found), times(-unit, exact)), linf, 1e-12 * linf));
  const auto again = [](std::vector<double> values) {  // each twice, and backwards
    values.insert(values.end(), values.begin(), values.end());
    std::ranges::reverse(values);
    return values;
  };
  RC_ASSERT(is_near(relative_l2(again(found), again(exact), again(weights)), l2, 1e-12 * l2));
  RC_ASSERT(relative_linf(again(found), again(exact)) == linf);
}

}  // namespace norms_test
}  // namespace touchstone::vnv
