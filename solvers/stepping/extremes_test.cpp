#include "solvers/stepping/extremes.hpp"

#include "solvers/fluids/tait.hpp"

#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(Extremes, AreTheGreatestSpeedAndDensityOfTheFluidAlone) {
  FluidState all;
  all.fluid = 3;
  all.vx = Scalars{{3, -1, 0, 100}};  // the last is no fluid
  all.vy = Scalars{{4, 0, -6, 100}};
  all.rho = Scalars{{999, 1003, 1001, 5000}};
  EXPECT_EQ(extremes_of(all).speed, 6);
  EXPECT_EQ(extremes_of(all).density, 1003);
}

TEST(Signal, TravelsAtTheSpeedOfSoundOfTheDensestPlusThatOfTheFastest) {
  const Tait water{.density = 1000, .bulk_modulus = 1000 * 49. / 7};  // sound at 7 m/s
  EXPECT_NEAR(signal_speed(water, Extremes{.speed = 2, .density = 1000}), 9, 1e-12);
  EXPECT_NEAR(signal_speed(water, Extremes{.speed = 0, .density = 1100}), 7 * std::pow(1.1, 3), 1e-12);
}

}  // namespace
}  // namespace touchstone
