#include "vnv/measures/roughness.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace touchstone::vnv {
namespace {

/// 20 x 20 particles, one apart, with a pressure.
Samples square_of(const std::function<double(double, double)>& p) {
  constexpr int n = 20;
  Samples s{.x = Vectors(2, n * n), .pressure = Scalars(n * n)};
  for (int k = 0; k < n * n; ++k) {
    s.x.col(k) << k % n - 7.3, k / n - 4.1;
    s.pressure[k] = p(s.x(0, k), s.x(1, k));
  }
  return s;
}

TEST(Roughness, OfALinearFieldIsNothing) {
  const Samples s = square_of([](double x, double y) { return 1000 - 30 * x + 7 * y; });
  EXPECT_NEAR(roughness(s, pressure, 2.5), 0, 1e-10);
}

TEST(Roughness, OfACheckerboardIsItsHeight) {
  const Samples s = square_of([](double x, double y) { return std::lround(x + y + 11.4) % 2 == 0 ? 5.0 : -5.0; });
  EXPECT_NEAR(roughness(s, pressure, 2.5), 5, 0.5);
}

TEST(Roughness, OfASmoothFieldFallsWithTheSquareOfTheRadius) {
  const Samples s = square_of([](double x, double) { return std::sin(x / 6); });
  EXPECT_NEAR(roughness(s, pressure, 5.1) / roughness(s, pressure, 2.6), 4, 0.8);
}

TEST(Roughness, IsNotANumberWhereAFieldIsNot) {
  Samples s = square_of([](double x, double y) { return x + y; });
  s.pressure[17] = not_a_number;
  EXPECT_TRUE(std::isnan(roughness(s, pressure, 2.5)));
}

TEST(Roughness, LeavesOutParticlesThatAreAlone) {
  Samples s = square_of([](double x, double y) { return x + y; });
  s.x.col(0) << 500, 500;
  s.pressure[0] = 1e9;
  EXPECT_NEAR(roughness(s, pressure, 2.5), 0, 1e-9);
  EXPECT_TRUE(std::isnan(roughness(s, pressure, 0.5)));
}

TEST(Roughness, IsToldOfEveryTimeOfARun) {
  const vnv::Run run{.samples = {square_of([](double x, double y) { return x * y; })}};
  const std::vector<Value> errors =
      roughness_of("pressure", pressure, "rho g h", 100)({.name = "M1", .spacing = 1}, run);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].quantity.heading(), "pressure roughness over rho g h [%]");
  EXPECT_NEAR(errors[0].value, 100 * roughness(run.samples[0], pressure, 2.5) / 100, 1e-12);
}

}  // namespace
}  // namespace touchstone::vnv
