#include "reference/hydrostatic.hpp"

#include "reference/calculus.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::reference {
namespace {

constexpr Hydrostatic column{.rho0 = 1000, .K = 14300, .g = 9.81, .h = 1};  // 10 m/s of sound: soft

TEST(Hydrostatic, WeightIsCarriedByPressure) {
  for (const double y : {0.1, 0.5, 0.9})
    EXPECT_NEAR(slope([](double z) { return column.p(z); }, y, 0.01), -column.rho(y) * column.g, 1e-6 * 9810);
}

TEST(Hydrostatic, ObeysTaitsLaw) {
  for (const double y : {0.0, 0.4, 1.0})
    EXPECT_NEAR(column.p(y), column.K * (std::pow(column.rho(y) / column.rho0, 7) - 1), 1e-9 * column.K);
}

TEST(Hydrostatic, HasNoPressureAtTheSurface) {
  EXPECT_EQ(column.p(1), 0);
  EXPECT_DOUBLE_EQ(column.rho(1), column.rho0);
}

TEST(Hydrostatic, StandsOnTheFloorWithAllItsMass) {
  EXPECT_NEAR(column.mass(), integral([](double y) { return column.rho(y); }, 0, 1), 1e-9 * column.mass());
}

TEST(Hydrostatic, OfAStiffFluidIsLinear) {
  constexpr Hydrostatic stiff{.rho0 = 1000, .K = 1e13, .g = 9.81, .h = 1};
  EXPECT_NEAR(stiff.p(0.25), 1000 * 9.81 * 0.75, 1e-5);
}

TEST(Hydrostatic, RefusesPlacesAboveTheSurface) {
  EXPECT_THROW(column.p(1.01), std::domain_error);
  EXPECT_THROW(column.p(std::numeric_limits<double>::quiet_NaN()), std::domain_error);
  EXPECT_THROW(Hydrostatic({.rho0 = 1, .K = 1, .g = 0, .h = 1}).p(0), std::domain_error);
  EXPECT_THROW(Hydrostatic({.rho0 = 1, .K = 1, .g = 1, .h = 1, .gamma = 1}).p(0), std::domain_error);
}

}  // namespace
}  // namespace touchstone::reference
