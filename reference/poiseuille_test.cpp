#include "reference/poiseuille.hpp"

#include "reference/calculus.hpp"
#include "reference/couette.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace touchstone::reference {
namespace poiseuille_test {

constexpr Poiseuille flow{.H = 1e-3, .F = 8e-3, .nu = 1e-6};             // Sun et al., table 1
constexpr double viscous_time = flow.H * flow.H / flow.nu;               // s
constexpr double top_speed = flow.F * flow.H * flow.H / (8 * flow.nu);   // m/s
const std::vector<double> scaled_times = {1e-3, 0.005, 0.02, 0.1, 0.5};  // nu t / H², on both sides of the crossover
const std::vector<double> heights = {0.03, 0.1, 0.25, 0.5, 0.62, 0.9};   // y / H

double at(double height, double scaled_time) { return flow(height * flow.H, scaled_time * viscous_time); }

TEST(Poiseuille, StartsFromRest) {
  for (const double height : {0.0, 0.1, 0.5, 1.0}) EXPECT_EQ(at(height, 0), 0) << height;
  EXPECT_LT(at(0.3, 1e-320), 1e-300);  // where nu t / H² is no longer a normal number
}

TEST(Poiseuille, IsAlikeAboveAndBelowTheMiddle) {
  for (const double time : scaled_times)
    for (const double height : heights) EXPECT_NEAR(at(height, time), at(1 - height, time), 1e-14 * top_speed);
}

TEST(Poiseuille, FlowsAlongTheForce) {  // (36) as printed flows against it
  for (const double time : scaled_times)
    for (const double height : heights) EXPECT_GT(at(height, time), 0);
}

TEST(Poiseuille, FallsFreelyBeforeItFeelsTheWalls) {
  const double t = 1e-6 * viscous_time;
  EXPECT_NEAR(flow(flow.H / 2, t), flow.F * t, 1e-15 * flow.F * t);
}

TEST(Poiseuille, WallLayersGrowWithTheRootOfTime) {
  for (const double height : {0.002, 0.005, 0.01})
    EXPECT_NEAR(4 * at(height, 1e-5), at(2 * height, 4e-5), 1e-13 * top_speed) << height;
}

TEST(Poiseuille, EndsAsTheParabola) {
  for (const double height : heights) EXPECT_DOUBLE_EQ(at(height, 1e3), flow.steady(height * flow.H)) << height;
  EXPECT_DOUBLE_EQ(flow.steady(flow.H / 2), top_speed);
  EXPECT_NEAR(slope([](double y) { return flow.steady(y); }, 0, flow.H / 10, gsl_deriv_forward) * flow.nu,
              flow.F * flow.H / 2, 1e-9 * flow.F * flow.H);  // the two walls carry the force
}

// Change of flow and of plate alike solve v_t = nu v_yy, and the walls stop F at once.
TEST(Poiseuille, AccelerationIsTheForceLessTwoCouetteFlows) {
  constexpr Couette plate{.H = flow.H, .V = flow.F, .nu = flow.nu};
  for (const double time : scaled_times)
    for (const double height : heights) {
      const double y = height * flow.H, t = time * viscous_time;
      const double change = slope([=](double s) { return flow(y, s); }, t, 0.05 * t);
      EXPECT_NEAR(change, flow.F - plate(y, t) - plate(flow.H - y, t), 1e-7 * flow.F) << height << ' ' << time;
    }
}

TEST(Poiseuille, PrintedCentrelineValuesEachLackANine) {
  struct Printed {
    double t, velocity, mended;  // s, mm/s, mm/s
  };
  for (const Printed& printed : {Printed{0.6, 0.9723, 0.99723}, {0.8, 0.9962, 0.99962}, {1.0, 0.9995, 0.99995}}) {
    const double velocity = 1e3 * flow(flow.H / 2, printed.t);  // mm/s
    EXPECT_NEAR(velocity, printed.mended, 0.5e-5) << printed.t;
    EXPECT_GT(std::abs(velocity - printed.velocity), 4 * 1e-4) << printed.t;  // four units of the last printed digit
  }
  EXPECT_NEAR(1e3 * flow(flow.H / 2, 10), 1, 1e-15);
}

}  // namespace poiseuille_test
}  // namespace touchstone::reference
