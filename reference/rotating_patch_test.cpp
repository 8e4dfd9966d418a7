#include "reference/rotating_patch.hpp"

#include "reference/calculus.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::reference {
namespace rotating_patch_test {

constexpr RotatingPatch patch{.L = 1, .omega = 2, .rho = 1000};
constexpr double scale = 1000 * 2 * 2 * 1 * 1;  // Pa  rho omega² L²

/// The other representation: sines along both sides, but for some 1e-8.
double by_double_series(double x, double y) {
  constexpr double pi = std::numbers::pi;
  double sum = 0;
  for (double m = 1; m < 600; m += 2)
    for (double n = 1; n < 600; n += 2)
      sum +=
          std::sin(m * pi * (x / patch.L + 0.5)) * std::sin(n * pi * (y / patch.L + 0.5)) / (m * n * (m * m + n * n));
  return -32 * scale / std::pow(pi, 4) * sum;
}

TEST(RotatingPatch, HasThePressureOfASeriesOfSines) {
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {0.1, -0.2}, {0.45, 0.02}, {-0.3, 0.49}, {0.48, 0.48}})
    EXPECT_NEAR(patch.p(x, y), by_double_series(x, y), 1e-7 * scale) << x << ", " << y;
}

TEST(RotatingPatch, SucksInItsMiddleAsATwistedSquareBarBends) {
  EXPECT_NEAR(patch.p(0, 0) / scale, -0.14734, 1e-5);  // Prandtl's function in the middle: 0.07367 x 2
}

TEST(RotatingPatch, ObeysPoissonsEquation) {
  const double x = 0.21, y = -0.13, h = 0.02;
  const auto along_x = [&](double s) { return slope([&](double r) { return patch.p(r, y); }, s, h); };
  const auto along_y = [&](double s) { return slope([&](double r) { return patch.p(x, r); }, s, h); };
  EXPECT_NEAR(slope(along_x, x, h) + slope(along_y, y, h), 2 * 1000 * 2 * 2, 1e-4 * scale);
}

TEST(RotatingPatch, HasNoPressureOnItsSides) {
  for (const double s : {-0.5, -0.3, 0.0, 0.41, 0.499}) {
    EXPECT_NEAR(patch.p(0.5, s), 0, 1e-10 * scale);
    EXPECT_NEAR(patch.p(s, -0.5), 0, 1e-10 * scale);
  }
}

TEST(RotatingPatch, LooksTheSameAfterAQuarterTurn) {
  EXPECT_DOUBLE_EQ(patch.p(0.3, 0.1), patch.p(-0.1, 0.3));
  EXPECT_DOUBLE_EQ(patch.p(0.3, 0.1), patch.p(0.1, 0.3));
}

TEST(RotatingPatch, KeepsWhatItsFieldsHold) {
  const auto over_square = [](auto f) {
    return integral([&](double x) { return integral([&](double y) { return f(x, y); }, -0.5, 0.5); }, -0.5, 0.5);
  };
  EXPECT_NEAR(patch.kinetic_energy(), 500 * over_square([](double x, double y) {
                                        return patch.v_x(y) * patch.v_x(y) + patch.v_y(x) * patch.v_y(x);
                                      }),
              1e-9);
  EXPECT_EQ(patch.mass(), 1000);
}

TEST(RotatingPatch, RefusesWhatIsNoPatch) {
  EXPECT_THROW(RotatingPatch({.L = 0, .omega = 1, .rho = 1}).p(0, 0), std::domain_error);
  EXPECT_THROW(RotatingPatch({.L = 1, .omega = -1, .rho = 1}).p(0, 0), std::domain_error);
  EXPECT_THROW(RotatingPatch({.L = 1, .omega = 1, .rho = 0}).p(0, 0), std::domain_error);
  EXPECT_THROW(patch.p(0.51, 0), std::domain_error);
  EXPECT_THROW(patch.p(0, std::numeric_limits<double>::quiet_NaN()), std::domain_error);
}

}  // namespace rotating_patch_test
}  // namespace touchstone::reference
