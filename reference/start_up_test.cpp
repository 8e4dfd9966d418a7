#include "reference/start_up.hpp"

#include "reference/calculus.hpp"
#include "reference/couette.hpp"
#include "reference/poiseuille.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace touchstone::reference {
namespace start_up_test {

TEST(StartUp, ErfcVanishesFarOutWhereGslIsNotANumber) {
  for (const double z : {27.0, 1e10, 1e60, 1e300}) {
    EXPECT_EQ(erfc(z), 0) << z;
    EXPECT_EQ(i2erfc(z), 0) << z;
  }
}

TEST(StartUp, ErfcIntegratedTwiceIsTheIntegralOfErfc) {
  for (const double z : {0.0, 0.1, 0.7, 1.5, 3.0, 5.0}) {
    const double twice = integral([=](double u) { return (u - z) * erfc(u); }, z, 12);
    EXPECT_NEAR(i2erfc(z), twice, 1e-14 + 1e-9 * twice) << z;
  }
}

TEST(StartUp, SumStopsWhereItsBoundIsNegligible) {
  int terms = 0;
  const auto half_power = [&](double n) { return ++terms, std::exp2(-n); };
  const double total = sum(1, 1, half_power, [](double n) { return std::exp2(1 - n); });
  EXPECT_NEAR(total, 1, 2 * negligible);
  EXPECT_EQ(terms, 53);  // the next is half a rounding error of 1
}

TEST(StartUp, PlacesAreClampedOnlyByRounding) {
  EXPECT_EQ(scaled("here", 2 + 1e-13, 1, 2, 1).y, 1);
  EXPECT_EQ(scaled("here", -1e-13, 1, 2, 1).y, 0);
  EXPECT_THROW(scaled("here", 2 + 1e-11, 1, 2, 1), std::domain_error);
  EXPECT_THROW(scaled("here", -1e-11, 1, 2, 1), std::domain_error);
}

// What holds of both flows, with the scales of each; those of Sun et al., section 3.

struct OfPoiseuille {
  static constexpr Poiseuille flow{.H = 1e-3, .F = 8e-3, .nu = 1e-6};
  static constexpr double force = flow.F, plate = 0;                            // m/s², m/s
  static constexpr double velocity = flow.F * flow.H * flow.H / (8 * flow.nu);  // m/s  the largest
  static double acceleration(double /*t*/) { return flow.F; }                   // m/s²
  static Poiseuille channel(double H, double F, double nu) { return {.H = H, .F = F, .nu = nu}; }
  static constexpr auto name = "Poiseuille", drive = "F [m/s²]";
};
struct OfCouette {
  static constexpr Couette flow{.H = 1e-3, .V = 1e-4, .nu = 1e-6};
  static constexpr double force = 0, plate = flow.V;           // m/s², m/s
  static constexpr double velocity = flow.V;                   // m/s  the largest
  static double acceleration(double t) { return flow.V / t; }  // m/s²
  static Couette channel(double H, double V, double nu) { return {.H = H, .V = V, .nu = nu}; }
  static constexpr auto name = "Couette", drive = "V [m/s]";
};

constexpr double viscous_time = 1;                                       // s  H² / nu of both
const std::vector<double> scaled_times = {1e-3, 0.005, 0.02, 0.1, 0.5};  // nu t / H², on both sides of the crossovers
const std::vector<double> heights = {0.03, 0.1, 0.25, 0.5, 0.62, 0.9, 0.97};  // y / H

/// Between the two representations, over the velocity scale, over the gap and two decades of nu t / H².
template <class Of>
double largest_difference(double first_power) {
  double largest = 0;
  for (double power = first_power; power < first_power + 2; power += 0.0625)
    for (int i = 0; i <= 200; ++i) {
      const double y = i * Of::flow.H / 200, t = std::pow(10, power) * viscous_time;
      const double difference = std::abs(Of::flow.fourier(y, t) - Of::flow.images(y, t)) / Of::velocity;
      if (std::isnan(difference)) return difference;
      largest = std::max(largest, difference);
    }
  return largest;
}

template <class Flow>
std::string refusal(const Flow& flow, double y, double t) {
  try {
    flow(y, t);
  } catch (const std::domain_error& error) {
    return error.what();
  }
  return "accepted";
}

template <class Of>
struct StartUpFlow : testing::Test {};
using Flows = testing::Types<OfPoiseuille, OfCouette>;
TYPED_TEST_SUITE(StartUpFlow, Flows);

TYPED_TEST(StartUpFlow, SticksToBothPlates) {
  for (const double time : {1e-6, 1e-3, 0.02, 0.5, 1e3}) {
    const double t = time * viscous_time;
    EXPECT_NEAR(TypeParam::flow(0, t), 0, 1e-15 * TypeParam::velocity) << time;
    EXPECT_NEAR(TypeParam::flow(TypeParam::flow.H, t), TypeParam::plate, 1e-15 * TypeParam::velocity) << time;
  }
}

TYPED_TEST(StartUpFlow, TwoRepresentationsAgree) {
  for (const int power : {-7, -5, -3, -1}) {
    const double difference = largest_difference<TypeParam>(power);
    EXPECT_LT(difference, 1e-12) << "from nu t / H² = 1e" << power;
    testing::Test::RecordProperty(fmt::format("largest_difference_from_1e{}", power),
                                  fmt::format("{:.3g}", difference));
  }
}

TYPED_TEST(StartUpFlow, TwoRepresentationsAgreeToRoundingAboutTheCrossover) {
  EXPECT_LT(largest_difference<TypeParam>(-3), 4e-15);
}

TYPED_TEST(StartUpFlow, SolvesItsEquation) {
  constexpr auto& flow = TypeParam::flow;
  for (const double time : scaled_times)
    for (const double height : heights) {
      const double y = height * flow.H, t = time * viscous_time;
      const auto shear = [=](double place) {
        return slope([=](double z) { return flow(z, t); }, place, 0.01 * flow.H);
      };
      const double change = slope([=](double s) { return flow(y, s); }, t, 0.05 * t);
      EXPECT_NEAR(change, TypeParam::force + flow.nu * slope(shear, y, 0.01 * flow.H),
                  1e-5 * TypeParam::acceleration(t))
          << height << ' ' << time;
    }
}

TYPED_TEST(StartUpFlow, KeepsTheMomentumThatForceAndPlatesGive) {
  constexpr auto& flow = TypeParam::flow;
  for (const double time : scaled_times) {
    const double t = time * viscous_time, step = 0.01 * flow.H;
    const auto momentum = [=](double s) { return integral([=](double y) { return flow(y, s); }, 0, flow.H); };
    const auto profile = [=](double y) { return flow(y, t); };
    const double force = TypeParam::force * flow.H;
    const double drag =
        flow.nu * (slope(profile, flow.H, step, gsl_deriv_backward) - slope(profile, 0, step, gsl_deriv_forward));
    EXPECT_NEAR(slope(momentum, t, 0.05 * t), force + drag, 1e-5 * std::max(force, drag)) << time;
  }
}

TYPED_TEST(StartUpFlow, RefusesWhatIsNotAChannel) {
  const std::string name = TypeParam::name;
  const auto refused = [&](double H, double drive, double nu) {
    return refusal(TypeParam::channel(H, drive, nu), 0, 1);
  };
  EXPECT_EQ(refused(0, 1, 1), name + ": H [m] = 0, expected a finite number above 0");
  EXPECT_EQ(refused(1, 1, -2), name + ": nu [m²/s] = -2, expected a finite number above 0");
  EXPECT_EQ(refused(1, std::nan(""), 1), fmt::format("{}: {} = nan, expected a finite number", name, TypeParam::drive));
  EXPECT_THROW(TypeParam::channel(-1, 1, 1).steady(0), std::domain_error);
}

TYPED_TEST(StartUpFlow, RefusesPlacesAndTimesOutsideIt) {
  const auto unit = TypeParam::channel(1, 1, 1);
  const std::string name = TypeParam::name;
  EXPECT_EQ(refusal(unit, 1.25, 1), name + ": y [m] = 1.25, expected a place in [0, 1]");
  EXPECT_EQ(refusal(unit, 0.5, -1), name + ": t [s] = -1, expected a finite time, not negative");
  for (const double y : {-0.1, std::nan("")}) EXPECT_NE(refusal(unit, y, 1), "accepted") << y;
  for (const double t : {std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_NE(refusal(unit, 0.5, t), "accepted") << t;
}

TYPED_TEST(StartUpFlow, RepresentationsRefuseTimesThatAreNotTheirs) {
  EXPECT_THROW(TypeParam::flow.fourier(0, 0), std::domain_error);
  EXPECT_THROW(TypeParam::flow.images(0, 11 * viscous_time), std::domain_error);
}

}  // namespace start_up_test
}  // namespace touchstone::reference
