#include "vnv/judge/grid_convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace touchstone::vnv {
namespace {

const std::vector<double> ladder{0.08, 0.056, 0.04, 0.028, 0.02, 0.014, 0.01};  // m

std::vector<double> values_of(const std::function<double(double)>& law) {
  std::vector<double> values;
  for (const double h : ladder) values.push_back(law(h));
  return values;
}

TEST(TheGridConvergenceIndex, OfThePublishedExampleIsThePublishedOne) {
  // Celik et al. (2008), table 1, first column: reattachment length on 18000, 8000 and 4500 cells.
  const auto found = grid_convergence({4.0 / 3 * 1.5, 1.5, 1}, {5.863, 5.972, 6.063});
  EXPECT_NEAR(found.order, 1.53, 0.01);
  EXPECT_NEAR(found.extrapolated, 6.1685, 5e-4);
  EXPECT_NEAR(found.index, 0.022, 5e-4);
  EXPECT_FALSE(found.oscillates);
}

TEST(TheGridConvergenceIndex, OfAPowerLawFindsItsOrderAndItsLimit) {
  for (const double p : {1.0, 2.0, 3.0}) {
    const auto law = [p](double h) { return 3 + 0.2 * std::pow(h, p); };
    const auto found = grid_convergence({0.05, 0.02, 0.01}, {law(0.05), law(0.02), law(0.01)});
    EXPECT_NEAR(found.order, p, 1e-8);
    EXPECT_NEAR(found.extrapolated, 3, 1e-10);
    EXPECT_NEAR(found.index, 1.25 * (law(0.01) - 3) / law(0.01), 1e-10);
  }
}

TEST(TheGridConvergenceIndex, SaysWhereTheValuesJumpToAndFro) {
  EXPECT_TRUE(grid_convergence({4, 2, 1}, {1, 2, 1.5}).oscillates);
}

TEST(TheGridConvergenceIndex, OfEqualValuesIsNotANumber) {
  EXPECT_TRUE(std::isnan(grid_convergence({4, 2, 1}, {1, 1, 2}).index));
  EXPECT_TRUE(std::isnan(grid_convergence({4, 2, 1}, {1, 2, 2}).index));
  EXPECT_TRUE(std::isnan(grid_convergence({4, 2, 1}, {1, not_a_number, 2}).index));
}

TEST(TheGridConvergenceIndex, RefusesSpacingsThatDoNotFall) {
  EXPECT_THROW(grid_convergence({1, 2, 4}, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(grid_convergence({2, 1, 0}, {1, 2, 3}), std::invalid_argument);
}

TEST(NumericalUncertainty, OfASmoothLadderIsItsErrorTimesOneAndAQuarter) {
  for (const double p : {1.0, 1.5, 2.0}) {
    const auto found = numerical_uncertainty(ladder, values_of([p](double h) { return 3 + 0.2 * std::pow(h, p); }));
    EXPECT_NEAR(found.order, p, 1e-5);
    EXPECT_NEAR(found.extrapolated, 3, 1e-7);
    EXPECT_EQ(found.safety, 1.25);
    EXPECT_NEAR(found.uncertainty, 1.25 * 0.2 * std::pow(0.01, p), 1e-7);
  }
}

TEST(NumericalUncertainty, DoesNotBelieveAnOrderAboveTwo) {
  const auto found = numerical_uncertainty(ladder, values_of([](double h) { return 3 + 20 * std::pow(h, 4); }));
  EXPECT_NEAR(found.order, 4, 1e-4);
  EXPECT_EQ(found.safety, 3);
  EXPECT_GT(found.uncertainty, 20 * std::pow(0.01, 4));
}

TEST(NumericalUncertainty, HoldsTheTruthOfANoisyLadderNineteenTimesInTwenty) {
  std::mt19937_64 generator(20261121);
  std::normal_distribution<double> normal;
  constexpr int repeats = 500;
  int held = 0;
  for (int i = 0; i < repeats; ++i) {
    const auto values = values_of([&](double h) { return 3 + 0.2 * h * h + 2e-5 * normal(generator); });
    held += std::abs(values.back() - 3) <= numerical_uncertainty(ladder, values).uncertainty;
  }
  EXPECT_GE(held, 0.95 * repeats);
}

TEST(NumericalUncertainty, OfScatterAloneIsLargerThanTheScatter) {
  const auto found = numerical_uncertainty({8, 4, 2, 1}, {1, 1.2, 0.9, 1.1});
  EXPECT_EQ(found.safety, 3);
  EXPECT_GT(found.uncertainty, 0.1);
}

TEST(NumericalUncertainty, OfEqualValuesIsNone) {
  EXPECT_EQ(numerical_uncertainty({8, 4, 2, 1}, {3, 3, 3, 3}).uncertainty, 0);
}

TEST(NumericalUncertainty, OfWhatIsNoNumberIsNotANumber) {
  EXPECT_TRUE(std::isnan(numerical_uncertainty({8, 4, 2, 1}, {3, not_a_number, 3, 3}).uncertainty));
}

TEST(NumericalUncertainty, WantsFourValuesOnAFallingLadder) {
  EXPECT_THROW(numerical_uncertainty({4, 2, 1}, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(numerical_uncertainty({8, 4, 2, 1}, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(numerical_uncertainty({1, 2, 4, 8}, {1, 2, 3, 4}), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::vnv
