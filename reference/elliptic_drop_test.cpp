#include "reference/elliptic_drop.hpp"

#include "reference/calculus.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::reference {
namespace {

constexpr EllipticDrop drop{.R = 1, .s0 = 100, .rho = 1000};  // as Monaghan's

/// By the energy, which is kept: s² (a² + b²) = 2 s0² R². For a drop of known length, with R = 1.
double rate_of_strain(double a) { return drop.s0 * std::sqrt(2 / (a * a + 1 / (a * a))); }

TEST(EllipticDrop, StartsRoundWithHalfThePressureOfItsSpeed) {
  const auto start = drop.at(0);
  EXPECT_EQ(start.a, 1);
  EXPECT_EQ(start.b, 1);
  EXPECT_EQ(start.s, 100);
  EXPECT_DOUBLE_EQ(start.p_centre, 1000 * 100 * 100 / 2.0);
}

TEST(EllipticDrop, KeepsItsEnergyAndItsArea) {
  for (const double t : {0.001, 0.0076, 0.02, 0.1, 5.0}) {
    const auto now = drop.at(t);
    EXPECT_NEAR(now.s, rate_of_strain(now.a), 1e-11 * now.s) << t;
    EXPECT_NEAR(now.a * now.b, 1, 1e-14) << t;
  }
}

TEST(EllipticDrop, ObeysEulersEquationsAlongBothAxes) {
  for (const double t : {0.002, 0.0076, 0.02}) {
    const auto now = drop.at(t);
    const double change = slope([](double s) { return drop.at(s).s; }, t, 1e-4);
    const double x = 0.4, y = 0.3;
    const auto p_along_x = [&](double s) { return now.p(s, y); };
    const auto p_along_y = [&](double s) { return now.p(x, s); };
    const double scale = drop.s0 * drop.s0;
    EXPECT_NEAR((change + now.s * now.s) * x, -slope(p_along_x, x, 0.01) / drop.rho, 1e-7 * scale) << t;
    EXPECT_NEAR((now.s * now.s - change) * y, -slope(p_along_y, y, 0.01) / drop.rho, 1e-7 * scale) << t;
  }
}

TEST(EllipticDrop, GrowsAsItsFluidMoves) {
  const double t = 0.0076;
  EXPECT_NEAR(slope([](double s) { return drop.at(s).a; }, t, 1e-4), drop.at(t).s * drop.at(t).a, 1e-7);
}

TEST(EllipticDrop, HasNoPressureAtItsSurface) {
  const auto now = drop.at(0.0076);
  for (const double angle : {0.0, 0.7, 1.5})
    EXPECT_NEAR(now.p(now.a * std::cos(angle), now.b * std::sin(angle)), 0, 1e-9 * now.p_centre);
}

TEST(EllipticDrop, TakesAsLongToStretchAsItsEnergyAllows) {
  for (const double a : {1.1, 2.0, 5.0}) {
    const double t = integral([](double length) { return 1 / (length * rate_of_strain(length)); }, 1, a);
    EXPECT_NEAR(drop.at(t).a, a, 1e-9 * a);
  }
}

TEST(EllipticDrop, RefusesWhatIsNoDrop) {
  EXPECT_THROW(EllipticDrop({.R = 0, .s0 = 1, .rho = 1}).at(0), std::domain_error);
  EXPECT_THROW(EllipticDrop({.R = 1, .s0 = -1, .rho = 1}).at(0), std::domain_error);
  EXPECT_THROW(drop.at(-1), std::domain_error);
  EXPECT_THROW(drop.at(11), std::domain_error);
  EXPECT_THROW(drop.at(std::numeric_limits<double>::quiet_NaN()), std::domain_error);
}

}  // namespace
}  // namespace touchstone::reference
