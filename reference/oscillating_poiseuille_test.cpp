#include "reference/oscillating_poiseuille.hpp"

#include "reference/calculus.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::reference {
namespace oscillating_poiseuille_test {

OscillatingPoiseuille at_womersley(double number) {
  const double half = 5e-4, nu = 1e-6;
  return {.H = 2 * half, .F = 8e-3, .omega = number * number * nu / (half * half), .nu = nu};
}

double scale(const OscillatingPoiseuille& flow) {
  return std::min(flow.F / flow.omega, flow.F * flow.H * flow.H / (8 * flow.nu));
}

TEST(OscillatingPoiseuille, SolvesItsEquation) {
  for (const double number : {0.03, 0.3, 1.0, 5.0}) {
    const auto flow = at_womersley(number);
    for (const double phase : {0.4, 2.0, 5.0})
      for (const double height : {0.05, 0.3, 0.5}) {
        const double y = height * flow.H, t = phase / flow.omega;
        const auto shear = [=](double z) { return slope([=](double w) { return flow(w, t); }, z, 0.01 * flow.H); };
        const double change = slope([=](double s) { return flow(y, s); }, t, 0.01 / flow.omega);
        EXPECT_NEAR(change, flow.F * std::cos(phase) + flow.nu * slope(shear, y, 0.01 * flow.H),
                    1e-4 * flow.F)  // differences of differences
            << number << ' ' << phase << ' ' << height;
      }
  }
}

TEST(OscillatingPoiseuille, SticksToBothPlates) {
  for (const double number : {0.3, 1.0, 30.0})
    for (const double phase : {0.0, 1.0, 4.0}) {
      const auto flow = at_womersley(number);
      EXPECT_NEAR(flow(0, phase / flow.omega), 0, 1e-14 * scale(flow)) << number;
      EXPECT_NEAR(flow(flow.H, phase / flow.omega), 0, 1e-14 * scale(flow)) << number;
    }
}

TEST(OscillatingPoiseuille, OfASlowForceIsTheParabolaOfTheMoment) {
  for (const double number : {0.3, 1e-2, 1e-6}) {  // it lags by 5/12 of the square of that
    const auto flow = at_womersley(number);
    for (const double phase : {0.0, 1.0, 3.0})
      EXPECT_NEAR(flow(flow.H / 2, phase / flow.omega), flow.F * flow.H * flow.H / (8 * flow.nu) * std::cos(phase),
                  (0.5 * number * number + 1e-14) * scale(flow))
          << number;
  }
}

TEST(OscillatingPoiseuille, OfAFastForceIsAPlugThatLagsAQuarter) {
  const auto flow = at_womersley(100);
  for (const double phase : {0.5, 2.0})
    EXPECT_NEAR(flow(flow.H / 2, phase / flow.omega), flow.F / flow.omega * std::sin(phase), 1e-12 * scale(flow));
}

TEST(OscillatingPoiseuille, RefusesWhatIsNotAChannel) {
  EXPECT_THROW(OscillatingPoiseuille({.H = 0, .F = 1, .omega = 1, .nu = 1})(0, 0), std::domain_error);
  EXPECT_THROW(OscillatingPoiseuille({.H = 1, .F = 1, .omega = 0, .nu = 1})(0, 0), std::domain_error);
  EXPECT_THROW(at_womersley(1)(-1e-4, 0), std::domain_error);
  EXPECT_THROW(at_womersley(1)(0, std::numeric_limits<double>::infinity()), std::domain_error);
}

}  // namespace oscillating_poiseuille_test
}  // namespace touchstone::reference
