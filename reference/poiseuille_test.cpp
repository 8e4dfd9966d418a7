#include "reference/poiseuille.hpp"

#include "reference/calculus.hpp"
#include "reference/couette.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace touchstone::reference {
namespace {

constexpr Poiseuille flow{.H = 1e-3, .F = 8e-3, .nu = 1e-6};             // Sun et al., table 1
constexpr double viscous_time = flow.H * flow.H / flow.nu;               // s
constexpr double top_speed = flow.F * flow.H * flow.H / (8 * flow.nu);   // m/s
const std::vector<double> scaled_times = {1e-3, 0.005, 0.02, 0.1, 0.5};  // nu t / H², on both sides of the crossover
const std::vector<double> heights = {0.03, 0.1, 0.25, 0.5, 0.62, 0.9};   // y / H

double at(double height, double scaled_time) { return flow(height * flow.H, scaled_time * viscous_time); }

std::string refusal(const Poiseuille& channel, double y, double t) {
  try {
    channel(y, t);
  } catch (const std::domain_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Poiseuille, StartsFromRest) {
  for (const double height : {0.0, 0.1, 0.5, 1.0}) EXPECT_EQ(at(height, 0), 0) << height;
  EXPECT_LT(at(0.3, 1e-320), 1e-300);  // where nu t / H² is no longer a normal number
}

TEST(Poiseuille, SticksToBothPlates) {
  for (const double time : {1e-6, 1e-3, 0.02, 0.5, 1e3}) {
    EXPECT_NEAR(at(0, time), 0, 1e-15 * top_speed) << time;
    EXPECT_NEAR(at(1, time), 0, 1e-15 * top_speed) << time;
  }
}

TEST(Poiseuille, IsAlikeAboveAndBelowTheMiddle) {
  for (const double time : scaled_times)
    for (const double height : heights) EXPECT_NEAR(at(height, time), at(1 - height, time), 1e-14 * top_speed);
}

TEST(Poiseuille, FlowsAlongTheForce) {  // (36) as printed flows against it
  for (const double time : scaled_times)
    for (const double height : heights) EXPECT_GT(at(height, time), 0);
}

TEST(Poiseuille, FallsFreelyBeforeItFeelsTheWalls) {
  const double t = 1e-6 * viscous_time;
  EXPECT_NEAR(flow(flow.H / 2, t), flow.F * t, 1e-15 * flow.F * t);
}

TEST(Poiseuille, WallLayersGrowWithTheRootOfTime) {
  for (const double height : {0.002, 0.005, 0.01})
    EXPECT_NEAR(4 * at(height, 1e-5), at(2 * height, 4e-5), 1e-13 * top_speed) << height;
}

TEST(Poiseuille, EndsAsTheParabola) {
  for (const double height : heights) EXPECT_DOUBLE_EQ(at(height, 1e3), flow.steady(height * flow.H)) << height;
  EXPECT_DOUBLE_EQ(flow.steady(flow.H / 2), top_speed);
  EXPECT_NEAR(slope([](double y) { return flow.steady(y); }, 0, flow.H / 10, gsl_deriv_forward) * flow.nu,
              flow.F * flow.H / 2, 1e-9 * flow.F * flow.H);  // the two walls carry the force
}

/// Between the two representations, in units of the velocity scale, over the gap and two decades of nu t / H².
double largest_difference(double first_power) {
  double largest = 0;
  for (double power = first_power; power < first_power + 2; power += 0.0625)
    for (int i = 0; i <= 200; ++i) {
      const double y = i * flow.H / 200, t = std::pow(10, power) * viscous_time;
      const double difference = std::abs(flow.fourier(y, t) - flow.images(y, t)) / top_speed;
      if (std::isnan(difference)) return difference;
      largest = std::max(largest, difference);
    }
  return largest;
}

TEST(Poiseuille, TwoRepresentationsAgree) {
  for (const int power : {-7, -5, -3, -1}) {
    const double difference = largest_difference(power);
    EXPECT_LT(difference, 1e-12) << "from nu t / H² = 1e" << power;
    RecordProperty(fmt::format("largest_difference_from_1e{}", power), fmt::format("{:.3g}", difference));
  }
}

TEST(Poiseuille, TwoRepresentationsAgreeToRoundingAboutTheCrossover) { EXPECT_LT(largest_difference(-3), 4e-15); }

TEST(Poiseuille, SolvesItsEquation) {
  for (const double time : scaled_times)
    for (const double height : heights) {
      const double y = height * flow.H, t = time * viscous_time;
      const auto shear = [=](double place) {
        return slope([=](double z) { return flow(z, t); }, place, 0.01 * flow.H);
      };
      const double change = slope([=](double s) { return flow(y, s); }, t, 0.05 * t);
      EXPECT_NEAR(change, flow.F + flow.nu * slope(shear, y, 0.01 * flow.H), 1e-5 * flow.F) << height << ' ' << time;
    }
}

TEST(Poiseuille, WallsTakeTheMomentumThatTheFlowDoesNotKeep) {
  for (const double time : scaled_times) {
    const double t = time * viscous_time;
    const auto momentum = [](double s) { return integral([=](double y) { return flow(y, s); }, 0, flow.H); };
    const auto profile = [=](double y) { return flow(y, t); };
    const double step = 0.01 * flow.H;
    const double drag =
        flow.nu * (slope(profile, 0, step, gsl_deriv_forward) - slope(profile, flow.H, step, gsl_deriv_backward));
    EXPECT_NEAR(slope(momentum, t, 0.05 * t), flow.F * flow.H - drag, 1e-5 * flow.F * flow.H) << time;
  }
}

// Change of flow and of plate alike solve v_t = nu v_yy, and the walls stop F at once.
TEST(Poiseuille, AccelerationIsTheForceLessTwoCouetteFlows) {
  constexpr Couette plate{.H = flow.H, .V = flow.F, .nu = flow.nu};
  for (const double time : scaled_times)
    for (const double height : heights) {
      const double y = height * flow.H, t = time * viscous_time;
      const double change = slope([=](double s) { return flow(y, s); }, t, 0.05 * t);
      EXPECT_NEAR(change, flow.F - plate(y, t) - plate(flow.H - y, t), 1e-7 * flow.F) << height << ' ' << time;
    }
}

TEST(Poiseuille, PrintedCentrelineValuesEachLackANine) {
  struct Printed {
    double t, velocity, mended;  // s, mm/s, mm/s
  };
  for (const Printed& printed : {Printed{0.6, 0.9723, 0.99723}, {0.8, 0.9962, 0.99962}, {1.0, 0.9995, 0.99995}}) {
    const double velocity = 1e3 * flow(flow.H / 2, printed.t);  // mm/s
    EXPECT_NEAR(velocity, printed.mended, 0.5e-5) << printed.t;
    EXPECT_GT(std::abs(velocity - printed.velocity), 4 * 1e-4) << printed.t;  // four units of the last printed digit
  }
  EXPECT_NEAR(1e3 * flow(flow.H / 2, 10), 1, 1e-15);
}

TEST(Poiseuille, RefusesWhatIsNotAChannel) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal({.H = 0, .F = 1, .nu = 1}, 0, 1), "Poiseuille: H [m] = 0, expected a finite number above 0");
  EXPECT_EQ(refusal({.H = 1, .F = 1, .nu = -2}, 0, 1), "Poiseuille: nu [m²/s] = -2, expected a finite number above 0");
  EXPECT_EQ(refusal({.H = 1, .F = nan, .nu = 1}, 0, 1), "Poiseuille: F [m/s²] = nan, expected a finite number");
  EXPECT_THROW(Poiseuille({.H = -1, .F = 1, .nu = 1}).steady(0), std::domain_error);
}

TEST(Poiseuille, RefusesPlacesAndTimesOutsideIt) {
  const Poiseuille unit{.H = 1, .F = 1, .nu = 1};
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(unit, 1.25, 1), "Poiseuille: y [m] = 1.25, expected a place in [0, 1]");
  EXPECT_EQ(refusal(unit, 0.5, -1), "Poiseuille: t [s] = -1, expected a finite time, not negative");
  for (const double y : {-0.1, std::nan("")}) EXPECT_NE(refusal(unit, y, 1), "accepted") << y;
  for (const double t : {infinite, std::nan("")}) EXPECT_NE(refusal(unit, 0.5, t), "accepted") << t;
}

TEST(Poiseuille, RepresentationsRefuseTimesThatAreNotTheirs) {
  EXPECT_THROW(flow.fourier(0, 0), std::domain_error);
  EXPECT_THROW(flow.images(0, 11 * viscous_time), std::domain_error);
}

}  // namespace
}  // namespace touchstone::reference
