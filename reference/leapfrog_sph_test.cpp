#include "reference/leapfrog_sph.hpp"

#include <gtest/gtest.h>

namespace touchstone::reference {
namespace {

const LeapfrogSph quintic = quintic_leapfrog(12), wendland{slope_of_wendland_c2, 2, 2, 12};

TEST(LeapfrogSph, HasKernelsThatIntegrateToOne) {  // 2 pi integral W q dq = -pi integral W' q² dq
  for (const LeapfrogSph& sph : {quintic, wendland}) {
    double integral = 0;
    constexpr int steps = 30000;
    for (int k = 0; k < steps; ++k) {
      const double q = (k + 0.5) * sph.support / steps;
      integral -= std::numbers::pi * sph.slope(q) * q * q * sph.support / steps;
    }
    EXPECT_NEAR(integral, 1, 1e-8);
  }
}

TEST(LeapfrogSph, SeesLongWavesAsTheyAre) {
  for (const LeapfrogSph& sph : {quintic, wendland}) {
    constexpr double k = 1e-3;
    EXPECT_NEAR(sph.gradient(k, 0) / k, 1, 0.01) << "the sums over a lattice are an integral to a hundredth";
    EXPECT_NEAR(sph.gradient(std::numbers::pi, std::numbers::pi), 0, 1e-14) << "rows that alternate are not seen";
  }
}

TEST(LeapfrogSph, IsStableUpToItsLargestStep) {
  const double courant = quintic.largest_stable_courant();
  for (const double part : {0.999, 1.001}) {
    double largest = 0;
    for (int i = 0; i <= 6; ++i)
      for (int j = 0; j <= 6; ++j) {  // v and rho in turn, a wave at a time
        const double phase = part * courant * quintic.gradient(std::numbers::pi * i / 6, std::numbers::pi * j / 6);
        double v = 1, rho = 0;
        for (int step = 0; step < 2000; ++step) {
          rho += phase * v;
          v -= phase * rho;
        }
        largest = std::max(largest, std::abs(v));
      }
    EXPECT_EQ(largest < 100, part < 1) << part;
  }
}

TEST(LeapfrogSph, IsTheSameInAnyOrderOfItsAxes) {
  EXPECT_DOUBLE_EQ(wendland.gradient(0.3, 1.1), wendland.gradient(1.1, 0.3));
  EXPECT_DOUBLE_EQ(wendland.gradient(0.3, 1.1), wendland.gradient(-0.3, 1.1));
}

TEST(LeapfrogSph, RefusesWhatIsNoLattice) {
  EXPECT_THROW((LeapfrogSph{slope_of_quintic_spline, 3, 0, 12}.largest_stable_courant()), std::domain_error);
  EXPECT_THROW((LeapfrogSph{slope_of_quintic_spline, 3, 1, 1}.largest_stable_courant()), std::domain_error);
}

}  // namespace
}  // namespace touchstone::reference
