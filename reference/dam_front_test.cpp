#include "reference/dam_front.hpp"

#include "reference/calculus.hpp"

#include <gtest/gtest.h>

namespace touchstone::reference {
namespace {

constexpr RitterFront dam{.g = 9.8, .h0 = 0.6, .l0 = 0.6};  // Sun et al., section 3.3
const double c0 = std::sqrt(dam.g * dam.h0);                // m/s
const double last = dam.l0 / c0;                            // s  the rarefaction reaches the back wall

/// Discharge [m²/s] through x, from nothing but the depth: what passes x is what stands beyond it.
double discharge(double x, double t) {
  return slope([=](double s) { return integral([=](double z) { return dam.depth(z, s); }, x, dam(s)); }, t, 0.01 * t);
}

TEST(RitterFront, StartsAtTheGateWithAStandingColumn) {
  EXPECT_EQ(dam(0), dam.l0);
  EXPECT_EQ(dam.depth(0.3, 0), dam.h0);
  EXPECT_EQ(dam.depth(dam.l0, 0), dam.h0);
  EXPECT_EQ(dam.depth(0.7, 0), 0);
}

TEST(RitterFront, RunsTwoLengthsPerUnitOfTime) {  // in L = x / l0 and T = t sqrt(g h0) / l0, whatever the column
  for (const RitterFront& any : {dam, RitterFront{9.81, 0.3, 0.6}, RitterFront{1.6, 2, 0.1}}) {
    const double unit = any.l0 / std::sqrt(any.g * any.h0);
    EXPECT_NEAR(slope([=](double T) { return any(T * unit) / any.l0; }, 1, 0.1), 2, 1e-9);
    EXPECT_NEAR(any.speed() * unit / any.l0, 2, 1e-14);
  }
}

TEST(RitterFront, DepthFallsToNothingAtTheFront) {
  const double t = last / 2, front = dam(t);
  EXPECT_EQ(dam.depth(front, t), 0);
  EXPECT_GT(dam.depth(0.99 * front, t), 0);
  EXPECT_LT(dam.depth(0.99 * front, t), 1e-2 * dam.h0);
  for (double x = 0; x < front; x += 0.01) EXPECT_GE(dam.depth(x, t), dam.depth(x + 0.01, t)) << x;
}

TEST(RitterFront, DepthAtTheGateStandsStill) {
  EXPECT_NEAR(dam.depth(dam.l0, last / 10), dam.depth(dam.l0, last), 1e-15);
}

TEST(RitterFront, KeepsItsWater) {
  for (const double t : {0.1 * last, 0.5 * last, last}) {
    const auto depth = [=](double x) { return dam.depth(x, t); };
    EXPECT_NEAR(integral(depth, 0, dam(t)), dam.h0 * dam.l0, 1e-9) << t;
  }
}

TEST(RitterFront, KeepsTheForwardRiemannInvariant) {  // u + 2 c is what it was in the column at rest
  const double t = last / 2;
  for (const double x : {0.4, 0.6, 0.9, 1.1}) {
    const double h = dam.depth(x, t);
    EXPECT_NEAR(discharge(x, t) / h + 2 * std::sqrt(dam.g * h), 2 * c0, 1e-6 * c0) << x;
  }
}

TEST(RitterFront, OutrunsTheWaveBackFromTheWall) {
  const RitterFront longer{.g = dam.g, .h0 = dam.h0, .l0 = 1000 * dam.l0};  // the same fan, for longer
  const double shift = longer.l0 - dam.l0;
  const auto speed = [&](double x, double t) {
    return 2 * c0 - std::sqrt(dam.g * longer.depth(x + shift, t));
  };  // u + c
  double x = 0, t = last, gap = dam(last);
  while (t < 100 * last) {
    const double step = 0.01 * t;
    x += step * speed(x + step / 2 * speed(x, t), t + step / 2);
    t += step;
    EXPECT_GT(dam(t) - x, gap) << t;
    gap = dam(t) - x;
  }
  EXPECT_NEAR(gap, 3 * dam.l0 * std::cbrt(t / last), 1e-3 * gap);  // as documented
}

TEST(RitterFront, RefusesWhatIsNotADam) {
  EXPECT_THROW((RitterFront{0, 1, 1}).speed(), std::domain_error);
  EXPECT_THROW((RitterFront{9.8, -1, 1})(0), std::domain_error);
  EXPECT_THROW((RitterFront{9.8, 1, std::nan("")}).depth(0, 0), std::domain_error);
}

TEST(RitterFront, RefusesPlacesAndTimesOutsideIt) {
  for (const double t : {-1.0, std::nan("")}) {
    EXPECT_THROW(dam(t), std::domain_error) << t;
    EXPECT_THROW(dam.depth(0.5, t), std::domain_error) << t;
  }
  EXPECT_THROW(dam.depth(-0.1, last / 2), std::domain_error);
  EXPECT_THROW(dam.depth(0.5, 1.001 * last), std::domain_error);
  EXPECT_NO_THROW(dam(100 * last));
}

}  // namespace
}  // namespace touchstone::reference
