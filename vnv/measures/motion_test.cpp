#include "vnv/measures/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace touchstone::vnv {
namespace motion_test {

/// A row of heavy and a row of light fluid that swing along x, with their velocity so many times.
Run swinging(double times_of_velocity, double per_period) {
  Run run;
  for (double k = 0; k <= 3 * per_period; ++k) {
    const double phase = 2 * std::numbers::pi * k / per_period;
    Samples s{.time = 0.1 * k, .x = Vectors(2, 2), .v = Vectors(2, 2)};
    s.x << std::cos(phase), 3 + std::cos(phase), 1, 2;
    s.v.row(0).setConstant(-times_of_velocity * std::sin(phase) * 2 * std::numbers::pi / (0.1 * per_period));
    s.v.row(1).setConstant(7);
    s.mass = Eigen::Array2d(1, 2);
    run.samples.push_back(s);
  }
  return run;
}

double part(const Run& run) {
  const Moment along_x{.of = [](const Vec2& x) { return x.x(); }, .slope = [](const Vec2&) { return Vec2(1, 0); }};
  return part_of_motion(along_x)({.name = "2 across", .spacing = 0.5}, run).at(0).value;
}

TEST(Motion, IsAllMadeByTheVelocityOfWhatMovesByIt) {
  EXPECT_NEAR(part(swinging(1, 100)), 1, 1e-3);
  EXPECT_NEAR(part(swinging(1, 5)), 0.86, 0.01) << "a fifth of a period between two times";
  EXPECT_NEAR(part(swinging(2, 100)), 2, 2e-3);
  EXPECT_NEAR(part(swinging(-1, 100)), -1, 1e-3);
  EXPECT_EQ(part(swinging(0, 100)), 0);
  EXPECT_TRUE(std::isnan(part(swinging(NAN, 100))));
}

TEST(Motion, IsNotMeasuredOfWhatDoesNotMove) {
  auto still = swinging(1, 100);
  still.samples.resize(1);
  EXPECT_THROW(part(still), std::invalid_argument);
}

}  // namespace motion_test
}  // namespace touchstone::vnv
