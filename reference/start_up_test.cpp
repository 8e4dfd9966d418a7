#include "reference/start_up.hpp"

#include "reference/calculus.hpp"

#include <gtest/gtest.h>

namespace touchstone::reference {
namespace {

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

}  // namespace
}  // namespace touchstone::reference
