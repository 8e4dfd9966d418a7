#include "reference/stokes.hpp"

#include "reference/calculus.hpp"
#include "reference/couette.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::reference {
namespace {

constexpr StokesFirst start{.V = 0.2, .nu = 1e-6};
constexpr StokesSecond swing{.V = 0.2, .omega = 50, .nu = 1e-6};
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// What is left of v_t = nu v_yy.
template <class Flow>
double residual(const Flow& flow, double y, double t) {
  const auto shear = [&](double place) { return slope([&](double z) { return flow(z, t); }, place, 1e-6); };
  return slope([&](double s) { return flow(y, s); }, t, 1e-3 * t) - flow.nu * slope(shear, y, 1e-6);
}

TEST(StokesFirst, SolvesItsEquation) {
  for (const double t : {0.02, 0.5})
    for (const double y : {5e-5, 2e-4, 6e-4})
      EXPECT_NEAR(residual(start, y, t), 0, 1e-5 * start.V / t) << y << ' ' << t;
}

TEST(StokesFirst, SticksToThePlateAndRestsFarAway) {
  for (const double t : {0.0, 1e-3, 1.0}) {
    EXPECT_EQ(start(0, t), start.V) << t;
    EXPECT_EQ(start(1, t), 0) << t;
  }
  EXPECT_EQ(start(1e-9, 0), 0);
}

TEST(StokesFirst, IsCouetteFlowBeforeTheOtherPlateIsFelt) {
  const Couette gap{.H = 1e-3, .V = start.V, .nu = start.nu};
  for (const double y : {1e-5, 1e-4, 3e-4}) EXPECT_NEAR(start(y, 5e-3), gap(gap.H - y, 5e-3), 1e-14);
}

TEST(StokesFirst, RefusesPlacesBelowThePlateAndTimesBeforeTheStart) {
  EXPECT_THROW(start(-1e-6, 1), std::domain_error);
  EXPECT_THROW(start(1e-6, -1), std::domain_error);
  EXPECT_THROW(start(nan, 1), std::domain_error);
  EXPECT_THROW(StokesFirst({.V = 1, .nu = 0})(0, 1), std::domain_error);
}

TEST(StokesSecond, SolvesItsEquation) {
  for (const double t : {0.013, 0.1})
    for (const double y : {5e-5, 2e-4, 6e-4})
      EXPECT_NEAR(residual(swing, y, t), 0, 1e-5 * swing.V * swing.omega) << y << ' ' << t;
}

TEST(StokesSecond, SticksToThePlateAndRestsFarAway) {
  for (const double t : {-0.3, 0.0, 0.011}) {
    EXPECT_DOUBLE_EQ(swing(0, t), swing.V * std::cos(swing.omega * t)) << t;
    EXPECT_NEAR(swing(50 * swing.layer(), t), 0, 1e-20) << t;
  }
}

TEST(StokesSecond, RefusesPlacesBelowThePlate) {
  EXPECT_THROW(swing(-1e-6, 1), std::domain_error);
  EXPECT_THROW(swing(0, nan), std::domain_error);
  EXPECT_THROW(StokesSecond({.V = 1, .omega = 0, .nu = 1})(0, 1), std::domain_error);
}

}  // namespace
}  // namespace touchstone::reference
