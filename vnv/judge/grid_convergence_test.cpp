#include "vnv/judge/grid_convergence.hpp"

#include "vnv/judge/testing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace touchstone::vnv {
namespace grid_convergence_test {

using Approach = GridConvergence::Trend;

/// Of f = 3 - 2 h^p at three spacings.
GridConvergence of_a_power(double p, double coarse, double middle, double fine) {
  const auto at = [=](double h) { return AtSpacing{h, 3 - 2 * std::pow(h, p)}; };
  return grid_convergence(at(coarse), at(middle), at(fine));
}

TEST(GridConvergence, FindsOrderAndLimitOfAPowerLawAtAnyRatiosOfSpacings) {
  for (const double p : {0.5, 1.0, 2.0, 4.3})
    for (const double coarse : {0.4, 0.3, 0.23}) {
      const GridConvergence found = of_a_power(p, coarse, 0.2, 0.1);
      EXPECT_EQ(found.trend, Approach::monotone);
      EXPECT_NEAR(found.order, p, 1e-9);
      EXPECT_NEAR(found.extrapolated, 3, 1e-10);
      EXPECT_NEAR(found.index, 1.25 * 2 * std::pow(0.1, p), 1e-10);
    }
}

TEST(GridConvergence, IsThatOfThePublishedExample) {
  // Celik et al. (2008), table 1: three grids of 18000, 8000 and 4500 cells in two dimensions, dimensionless
  // reattachment length; the order is printed as 1.53, the extrapolated value as 6.1685, the index as 2.2 %.
  const GridConvergence found =
      grid_convergence({1 / std::sqrt(4500.0), 5.863}, {1 / std::sqrt(8000.0), 5.972}, {1 / std::sqrt(18000.0), 6.063});
  EXPECT_NEAR(found.order, 1.53, 0.01);
  EXPECT_NEAR(found.extrapolated, 6.1685, 1e-3);
  EXPECT_NEAR(found.index / 6.063, 0.022, 5e-4);
}

TEST(GridConvergence, OfAnyValuesKnowsNoUnitNoSignAndNoZero) {
  int told = 0;
  EXPECT_TRUE(rc::check([&told] {
    std::vector<AtSpacing> ladder{{1, any_between(1, -1)}};
    for (const int coarser : {1, 2})
      ladder.insert(ladder.begin(), {ladder.front().spacing * any_between(2, 1.2), coarser * any_between(0, 2) - 1});
    const double metre = any_unit(3), unit = -any_unit(3), zero = unit * any_between(0, 1);
    std::vector<AtSpacing> others;
    for (const auto& [h, f] : ladder) others.push_back({metre * h, unit * f + zero});
    const GridConvergence found = grid_convergence(ladder[0], ladder[1], ladder[2]),
                          other = grid_convergence(others[0], others[1], others[2]);
    RC_ASSERT(other.trend == found.trend);
    const double u = numerical_uncertainty(ladder, 2).standard;
    RC_ASSERT(is_near(numerical_uncertainty(others, 2).standard, -unit * u, -unit * 1e-9 * u));
    if (found.trend != Approach::monotone) return;
    ++told;
    RC_ASSERT(is_near(other.order, found.order, 1e-7 * found.order));
    RC_ASSERT(is_near(other.extrapolated - zero, unit * found.extrapolated, -unit * 1e-7 * (1 + found.index)));
    RC_ASSERT(is_near(other.index, -unit * found.index, -unit * 1e-7 * found.index));
  }));
  EXPECT_GT(told, 20);
}

TEST(GridConvergence, IsNoNumberWhereNoPowerLawPasses) {
  EXPECT_EQ(grid_convergence({4, 1}, {2, 3}, {1, 2}).trend, Approach::oscillating);
  EXPECT_EQ(grid_convergence({4, 1}, {2, 2}, {1, 3}).trend, Approach::diverging) << "as a logarithm does";
  EXPECT_EQ(grid_convergence({4, 1}, {2, 1}, {1, 3}).trend, Approach::diverging);
  EXPECT_TRUE(std::isnan(grid_convergence({4, 1}, {2, 2}, {1, 4}).index));
}

TEST(GridConvergence, OfAValueThatDoesNotChangeIsThatValue) {
  EXPECT_EQ(grid_convergence({4, 1}, {2, 1}, {1, 1}).trend, Approach::constant);
  EXPECT_EQ(grid_convergence({4, 2}, {2, 1}, {1, 1}).extrapolated, 1);
  EXPECT_EQ(grid_convergence({4, 2}, {2, 1}, {1, 1}).index, 0);
}

/// Of 3 - 2 h^p at spacings of 0.4, 0.2 and 0.1.
std::vector<AtSpacing> ladder_of(double p) {
  std::vector<AtSpacing> ladder;
  for (const double h : {0.4, 0.2, 0.1}) ladder.push_back({h, 3 - 2 * std::pow(h, p)});
  return ladder;
}

TEST(NumericalUncertainty, IsTheIndexWhereTheOrderIsClear) {
  // Order 1: the value at 0.1 is 0.2 from the limit.
  const NumericalUncertainty found = numerical_uncertainty(ladder_of(1), 2);
  EXPECT_NEAR(found.standard, 1.25 * 0.2 / 1.15, 1e-12);
  EXPECT_NEAR(found.interval, 1.25 * 0.2, 1e-12);
  EXPECT_EQ(found.basis, "grid convergence index, observed order 1.00");
}

TEST(NumericalUncertainty, TakesNoHigherOrderThanTheMethods) {
  // Order 3: 2.984 and 2.998; by order 2 the limit is a third of the difference, 0.014 / 3, away.
  const NumericalUncertainty found = numerical_uncertainty(ladder_of(3), 2);
  EXPECT_NEAR(found.standard, 1.25 * 0.014 / 3 / 1.15, 1e-12);
  EXPECT_EQ(found.basis, "grid convergence index, observed order 3.00, taken as 2");
}

TEST(NumericalUncertainty, DoesNotTrustTheFinestTwoWhereTheyAgreeByChance) {
  const NumericalUncertainty found = numerical_uncertainty({{4, 1}, {2, 0.1}, {1, 0.1 - 1e-6}}, 1);
  EXPECT_NEAR(found.standard, 3 * 0.9 / 3 / 1.15, 1e-5);
  EXPECT_NE(found.basis.find("by chance"), std::string::npos) << found.basis;
}

TEST(NumericalUncertainty, IsOfTheRangeOfTheWholeLadderWhereTheOrderIsUnclear) {
  const std::string unclear = "3 times the range of 4 resolutions, as the order is unclear";
  const NumericalUncertainty swings = numerical_uncertainty({{8, 9}, {4, 1}, {2, 3}, {1, 2}}, 2);
  EXPECT_DOUBLE_EQ(swings.standard, 3 * (9.0 - 1) / 2);
  EXPECT_DOUBLE_EQ(swings.interval, 3 * (9.0 - 1));
  EXPECT_EQ(swings.basis, unclear);
  EXPECT_DOUBLE_EQ(numerical_uncertainty({{8, 0}, {4, 1}, {2, 2}, {1, 4}}, 2).standard, 6) << "diverges";
  EXPECT_DOUBLE_EQ(numerical_uncertainty({{8, 2}, {4, 2}, {2, 1}, {1, 1}}, 2).standard, 1.5) << "stands still";
  EXPECT_DOUBLE_EQ(numerical_uncertainty(ladder_of(0.3), 2).standard,
                   1.5 * 2 * (std::pow(0.4, 0.3) - std::pow(0.1, 0.3)))
      << "of too low an order";
  EXPECT_EQ(numerical_uncertainty({{4, 1}, {2, 1}, {1, 1}}, 2).standard, 0);
}

TEST(NumericalUncertainty, OfTwoResolutionsTakesTheFormalOrderAndOfOneIsUnknown) {
  EXPECT_NEAR(numerical_uncertainty({{2, 1}, {1, 4}}, 2).standard, 3 * 1 / 1.15, 1e-12);
  EXPECT_TRUE(std::isnan(numerical_uncertainty({{2, 1}}, 2).standard));
  EXPECT_TRUE(std::isnan(numerical_uncertainty({}, 2).standard));
  EXPECT_THROW(numerical_uncertainty({{1, 1}, {2, 4}}, 2), std::invalid_argument);
  EXPECT_THROW(numerical_uncertainty({{2, 1}, {1, 4}}, 0), std::invalid_argument);
}

TEST(GridConvergence, RefusesInOneLineWhatIsNoLadder) {
  EXPECT_THROW(grid_convergence({1, 1}, {2, 1}, {4, 1}), std::invalid_argument);
  EXPECT_THROW(grid_convergence({4, 1}, {2, std::numeric_limits<double>::infinity()}, {1, 1}), std::invalid_argument);
}

}  // namespace grid_convergence_test
}  // namespace touchstone::vnv
