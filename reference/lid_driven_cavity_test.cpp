#include "reference/lid_driven_cavity.hpp"

#include <gtest/gtest.h>

namespace touchstone::reference::lid_driven_cavity_test {

/// Solved once for all tests.
const LidDrivenCavity& at_100() {
  static const LidDrivenCavity cavity(100, 32);
  return cavity;
}

TEST(LidDrivenCavity, HasTheExtremaOfBotellaAndPeyret) {  // (1998), Re 100
  EXPECT_NEAR(at_100().u(0.5, 0.4581), -0.2140424, 1e-6);
  EXPECT_NEAR(at_100().v(0.2370, 0.5), 0.1795728, 1e-6);
  EXPECT_NEAR(at_100().v(0.8104, 0.5), -0.2538030, 1e-6);
}

TEST(LidDrivenCavity, NeitherSlipsNorLeaks) {
  for (const double s : {0.03, 0.2, 0.5, 0.77, 0.97}) {
    EXPECT_NEAR(at_100().u(s, 1), 1, 1e-4) << s;
    EXPECT_NEAR(at_100().v(s, 1), 0, 1e-4) << s;
    EXPECT_NEAR(std::hypot(at_100().u(s, 0), at_100().v(s, 0)), 0, 1e-5) << s;
    EXPECT_NEAR(std::hypot(at_100().u(0, s), at_100().v(0, s)), 0, 1e-4) << s;
    EXPECT_NEAR(std::hypot(at_100().u(1, s), at_100().v(1, s)), 0, 1e-4) << s;
  }
}

TEST(LidDrivenCavity, IsFreeOfDivergence) {
  constexpr double h = 1e-4;
  for (const double x : {0.1, 0.4, 0.8})
    for (const double y : {0.2, 0.6, 0.9}) {
      const double divergence =
          (at_100().u(x + h, y) - at_100().u(x - h, y) + at_100().v(x, y + h) - at_100().v(x, y - h)) / (2 * h);
      EXPECT_NEAR(divergence, 0, 1e-5) << x << ", " << y;
    }
}

TEST(LidDrivenCavity, ConvergesWithTheDegree) {
  const LidDrivenCavity coarse(100, 16), finer(100, 24);
  double of_coarse = 0, of_finer = 0;
  for (double s = 0.05; s < 1; s += 0.05) {
    of_coarse = std::max(of_coarse, std::abs(coarse.u(0.5, s) - at_100().u(0.5, s)));
    of_finer = std::max(of_finer, std::abs(finer.u(0.5, s) - at_100().u(0.5, s)));
  }
  EXPECT_LT(of_coarse, 2e-3);
  EXPECT_LT(of_finer, of_coarse / 8);
}

TEST(LidDrivenCavity, IsReachedFromASmallerReynoldsNumber) {
  const LidDrivenCavity cavity(400, 32, at_100());
  EXPECT_NEAR(cavity.v(0.9063, 0.5), -0.38968, 1e-4) << "Ghia's table has -0.23827 here";
}

TEST(LidDrivenCavity, IsReachedFromAnotherDegree) {
  const LidDrivenCavity cavity(100, 20, at_100()), at_rest(100, 20);
  for (const double s : {0.2, 0.5, 0.9}) EXPECT_NEAR(cavity.u(0.5, s), at_rest.u(0.5, s), 1e-9) << s;
}

TEST(LidDrivenCavity, IsRefusedWhereItCannotBeComputed) {
  EXPECT_THROW(LidDrivenCavity(0, 16), std::domain_error);
  EXPECT_THROW(LidDrivenCavity(100, 4), std::domain_error);
  EXPECT_THROW(LidDrivenCavity(1e6, 8), std::domain_error);
}

}  // namespace touchstone::reference::lid_driven_cavity_test
