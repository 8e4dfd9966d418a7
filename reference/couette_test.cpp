#include "reference/couette.hpp"

#include "reference/calculus.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace touchstone::reference {
namespace couette_test {

constexpr Couette flow{.H = 1e-3, .V = 1e-4, .nu = 1e-6};                // Sun et al., section 3.2
constexpr double viscous_time = flow.H * flow.H / flow.nu;               // s
const std::vector<double> scaled_times = {1e-3, 0.005, 0.02, 0.1, 0.5};  // nu t / H², on both sides of the crossover
const std::vector<double> heights = {0.1, 0.25, 0.5, 0.62, 0.9, 0.97};   // y / H

double at(double height, double scaled_time) { return flow(height * flow.H, scaled_time * viscous_time); }

TEST(Couette, StartsFromRestBelowThePlate) {
  for (const double height : {0.0, 0.5, 0.999}) EXPECT_EQ(at(height, 0), 0) << height;
  EXPECT_EQ(at(1, 0), flow.V);
  EXPECT_EQ(at(0.3, 1e-320), 0);
}

TEST(Couette, LagsBehindTheSteadyFlow) {
  for (const double time : scaled_times)
    for (const double height : heights) EXPECT_LT(at(height, time), flow.steady(height * flow.H));
}

TEST(Couette, LayerOfThePlateGrowsWithTheRootOfTime) {
  for (const double depth : {0.002, 0.005, 0.01})
    EXPECT_NEAR(at(1 - depth, 1e-5), at(1 - 2 * depth, 4e-5), 1e-13 * flow.V) << depth;
}

TEST(Couette, LeavesTheMiddleAtRestAtFirst) { EXPECT_EQ(at(0.5, 1e-6), 0); }

TEST(Couette, EndsAsTheStraightLine) {
  for (const double height : heights) EXPECT_DOUBLE_EQ(at(height, 1e3), flow.steady(height * flow.H)) << height;
  EXPECT_DOUBLE_EQ(flow.steady(flow.H / 4), flow.V / 4);
}

TEST(Couette, PrintedCentrelineValuesAreCutOff) {
  const auto centreline = [](double t) { return 1e3 * flow(flow.H / 2, t); };  // mm/s
  const auto five_digits = [](double velocity) { return std::floor(1e5 * velocity) / 1e5; };
  EXPECT_NEAR(centreline(0.6), 0.04983, 0.5e-5);  // this one is rounded
  EXPECT_DOUBLE_EQ(five_digits(centreline(0.8)), 0.04997);
  EXPECT_DOUBLE_EQ(five_digits(centreline(1.0)), 0.04999);
  EXPECT_GT(centreline(0.8) - 0.04997, 0.5e-5);  // rounded, they would be printed as 0.04998 and 0.05000
  EXPECT_GT(centreline(1.0) - 0.04999, 0.5e-5);
  EXPECT_NEAR(centreline(10), 0.05, 1e-16);
}

TEST(Couette, PrintedSumCannotStartAtNought) {
  const auto printed_term_at_plate = [](double n) {
    return 2 * flow.V / (n * std::numbers::pi) * std::sin(n * std::numbers::pi);
  };
  EXPECT_TRUE(std::isnan(printed_term_at_plate(0)));
  const double limit = printed_term_at_plate(1e-9);  // even this one would let the fluid outrun the plate threefold
  EXPECT_NEAR(flow.fourier(flow.H, viscous_time) + limit, 3 * flow.V, 1e-9 * flow.V);
}

}  // namespace couette_test
}  // namespace touchstone::reference
