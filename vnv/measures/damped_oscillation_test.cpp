#include "vnv/measures/damped_oscillation.hpp"

#include "vnv/measures/half_axes.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv {
namespace {

std::vector<double> times_until(double end) {
  std::vector<double> times;
  for (int k = 0; k <= 100; ++k) times.push_back(end * k / 100);
  return times;
}

TEST(DampedOscillation, IsFoundFromAWrongGuess) {
  const std::vector<double> times = times_until(4);
  std::vector<double> values;
  for (const double t : times) values.push_back(0.3 + 0.02 * std::exp(-0.158 * t) * std::cos(7.8 * t + 0.4));
  for (const double guess : {7.5, 8.1}) {
    const DampedOscillation found = fit_damped_oscillation(times, values, guess);
    EXPECT_NEAR(found.omega, 7.8, 1e-5);
    EXPECT_NEAR(found.decay, 0.158, 1e-5);
    EXPECT_NEAR(found.at_start, 0.02 * std::cos(0.4), 1e-6);
  }
}

TEST(DampedOscillation, MayGrow) {
  const std::vector<double> times = times_until(4);
  std::vector<double> values;
  for (const double t : times) values.push_back(std::exp(0.2 * t) * std::sin(5 * t));
  EXPECT_NEAR(fit_damped_oscillation(times, values, 5.1).decay, -0.2, 1e-5);
}

TEST(DampedOscillation, IsNoNumberForTooFewValuesAndForOneThatIsNone) {
  EXPECT_TRUE(std::isnan(fit_damped_oscillation({0, 1, 2}, {0, 1, 0}, 3).omega));
  std::vector<double> values(101, 1.0);
  values[7] = not_a_number;
  EXPECT_TRUE(std::isnan(fit_damped_oscillation(times_until(4), values, 3).omega));
}

TEST(HalfAxes, AreThoseOfAnEllipseHoweverItIsTurned) {
  const Mat2 turned = Eigen::Rotation2Dd(0.5).toRotationMatrix();
  Samples s;
  constexpr int across = 200;
  s.x.resize(2, across * across);
  Eigen::Index inside = 0;
  for (int k = 0; k < across * across; ++k) {
    const Vec2 x((k % across + 0.5) * 2 / across - 1, (k / across + 0.5) * 2 / across - 1);
    if (x.norm() < 1) s.x.col(inside++) = Vec2(7, -3) + turned * Vec2(3 * x.x(), 0.5 * x.y());
  }
  s.x.conservativeResize(2, inside);
  s.mass = Scalars::Constant(inside, 2);
  const auto axes = half_axes(s);
  EXPECT_NEAR(axes.longer, 3, 3e-3);
  EXPECT_NEAR(axes.shorter, 0.5, 5e-4);
}

}  // namespace
}  // namespace touchstone::vnv
