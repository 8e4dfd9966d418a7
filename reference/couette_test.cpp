#include "reference/couette.hpp"

#include "reference/calculus.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace touchstone::reference {
namespace {

constexpr Couette flow{.H = 1e-3, .V = 1e-4, .nu = 1e-6};                // Sun et al., section 3.2
constexpr double viscous_time = flow.H * flow.H / flow.nu;               // s
const std::vector<double> scaled_times = {1e-3, 0.005, 0.02, 0.1, 0.5};  // nu t / H², on both sides of the crossover
const std::vector<double> heights = {0.1, 0.25, 0.5, 0.62, 0.9, 0.97};   // y / H

double at(double height, double scaled_time) { return flow(height * flow.H, scaled_time * viscous_time); }

std::string refusal(const Couette& channel, double y, double t) {
  try {
    channel(y, t);
  } catch (const std::domain_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Couette, StartsFromRestBelowThePlate) {
  for (const double height : {0.0, 0.5, 0.999}) EXPECT_EQ(at(height, 0), 0) << height;
  EXPECT_EQ(at(1, 0), flow.V);
  EXPECT_EQ(at(0.3, 1e-320), 0);
}

TEST(Couette, SticksToBothPlates) {
  for (const double time : {1e-6, 1e-3, 0.02, 0.5, 1e3}) {
    EXPECT_NEAR(at(0, time), 0, 1e-15 * flow.V) << time;
    EXPECT_NEAR(at(1, time), flow.V, 1e-15 * flow.V) << time;
  }
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

/// Between the two representations, in units of the velocity scale, over the gap and two decades of nu t / H².
double largest_difference(double first_power) {
  double largest = 0;
  for (double power = first_power; power < first_power + 2; power += 0.0625)
    for (int i = 0; i <= 200; ++i) {
      const double y = i * flow.H / 200, t = std::pow(10, power) * viscous_time;
      const double difference = std::abs(flow.fourier(y, t) - flow.images(y, t)) / flow.V;
      if (std::isnan(difference)) return difference;
      largest = std::max(largest, difference);
    }
  return largest;
}

TEST(Couette, TwoRepresentationsAgree) {
  for (const int power : {-7, -5, -3, -1}) {
    const double difference = largest_difference(power);
    EXPECT_LT(difference, 1e-12) << "from nu t / H² = 1e" << power;
    RecordProperty(fmt::format("largest_difference_from_1e{}", power), fmt::format("{:.3g}", difference));
  }
}

TEST(Couette, TwoRepresentationsAgreeToRoundingAboutTheCrossover) { EXPECT_LT(largest_difference(-3), 4e-15); }

TEST(Couette, SolvesItsEquation) {
  for (const double time : scaled_times)
    for (const double height : heights) {
      const double y = height * flow.H, t = time * viscous_time;
      const auto shear = [=](double place) {
        return slope([=](double z) { return flow(z, t); }, place, 0.01 * flow.H);
      };
      const double change = slope([=](double s) { return flow(y, s); }, t, 0.05 * t);
      EXPECT_NEAR(t * change, t * flow.nu * slope(shear, y, 0.01 * flow.H), 1e-5 * flow.V) << height << ' ' << time;
    }
}

TEST(Couette, FlowKeepsTheMomentumThatThePlatesGive) {
  for (const double time : scaled_times) {
    const double t = time * viscous_time;
    const auto momentum = [](double s) { return integral([=](double y) { return flow(y, s); }, 0, flow.H); };
    const auto profile = [=](double y) { return flow(y, t); };
    const double step = 0.01 * flow.H;
    const double drag =
        flow.nu * (slope(profile, flow.H, step, gsl_deriv_backward) - slope(profile, 0, step, gsl_deriv_forward));
    EXPECT_NEAR(slope(momentum, t, 0.05 * t), drag, 1e-5 * drag) << time;
  }
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

TEST(Couette, RefusesWhatIsNotAChannel) {
  EXPECT_EQ(refusal({.H = -1, .V = 1, .nu = 1}, 0, 1), "Couette: H [m] = -1, expected a finite number above 0");
  EXPECT_EQ(refusal({.H = 1, .V = 1, .nu = 0}, 0, 1), "Couette: nu [m²/s] = 0, expected a finite number above 0");
  EXPECT_EQ(refusal({.H = 1, .V = std::nan(""), .nu = 1}, 0, 1), "Couette: V [m/s] = nan, expected a finite number");
  EXPECT_THROW(Couette({.H = 1, .V = 1, .nu = 1}).steady(2), std::domain_error);
}

TEST(Couette, RefusesPlacesAndTimesOutsideIt) {
  const Couette unit{.H = 1, .V = 1, .nu = 1};
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(unit, -0.25, 1), "Couette: y [m] = -0.25, expected a place in [0, 1]");
  for (const double y : {1.1, std::nan("")}) EXPECT_NE(refusal(unit, y, 1), "accepted") << y;
  for (const double t : {-1.0, infinite, std::nan("")}) EXPECT_NE(refusal(unit, 0.5, t), "accepted") << t;
}

TEST(Couette, RepresentationsRefuseTimesThatAreNotTheirs) {
  EXPECT_THROW(flow.fourier(0, 0), std::domain_error);
  EXPECT_THROW(flow.images(0, 11 * viscous_time), std::domain_error);
}

}  // namespace
}  // namespace touchstone::reference
