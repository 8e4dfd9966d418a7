#include "solvers/mpm/plain/with_budget.hpp"

#include "solvers/mpm/shapes/b_spline.hpp"
#include "solvers/mpm/shapes/linear_hat.hpp"
#include "solvers/testing.hpp"
#include "solvers/walls/free_slip.hpp"

namespace touchstone::mpm {
namespace budget_test {

constexpr double g = 9.81, potential = 1000 * 0.5 * 0.5 * g * 0.5 / 2;  // J/m  that the column begins with

/// A column of water that meets the far wall at about 0.3 s.
const Scene<Tait, Uniform> dam{
    .domain = {.box = {.high = {1, 4}}},
    .fluid = {.density = 1000, .bulk_modulus = 1000 * 30 * 30 / 7.0},
    .filled = {.high = {0.5, 0.5}},
    .walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(1, free_slip())},
    .body_force = {{0, -g}},
    .start = {.pressure = [](const Vec2& x) { return 1000 * g * (0.5 - x.y()); }},
};
constexpr Settings settings{.cell = 0.1, .spacing = 0.05, .time_step = 1e-3};
constexpr int steps = 600;

template <class Shape, class Transfer, class Density>
EnergyBudget budget_of() {
  WithBudget<Shape, Transfer, Density> simulation(dam, settings);
  for (int k = 0; k < steps; ++k) simulation.step();
  return *simulation.budget;
}
template <class Shape, class Transfer, class Density>
void expect_the_same_run() {
  auto plain = mpm::plain<Shape, Transfer, Density>(dam, settings);
  WithBudget<Shape, Transfer, Density> with_budget(dam, settings);
  for (int k = 0; k < steps; ++k) plain.step(), with_budget.step();
  const Samples a = plain.samples(), b = with_budget.samples();
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_TRUE((a.density == b.density).all());
}

TEST(EnergyBudgetOfMpm, KeepingItChangesNoBitOfARun) {
  expect_the_same_run<BSpline<2>, Apic, AffineDensity>();
  expect_the_same_run<LinearHat, Flip, CarriedDensity>();
}

TEST(EnergyBudgetOfMpm, AccountsForAllEnergyButRounding) {
  for (const EnergyBudget& budget :
       {budget_of<BSpline<2>, Apic, AffineDensity>(), budget_of<BSpline<2>, Xpic<5>, AffineDensity>(),
        budget_of<LinearHat, Flip, CarriedDensity>()}) {
    EXPECT_NEAR(budget.start.total(), potential, 0.01 * potential);
    EXPECT_NE(budget.transfer, 0);
    EXPECT_NEAR(budget.residual(), 0, 1e-12 * potential);
  }
}

TEST(EnergyBudgetOfMpm, PartsThatAMethodDoesNotHaveAddNothing) {
  const EnergyBudget budget = budget_of<LinearHat, Flip, CarriedDensity>();
  EXPECT_EQ(budget.smoothing, 0);
  EXPECT_EQ(budget.viscosity, 0);
  EXPECT_EQ(budget.shifting, 0);
}

TEST(EnergyBudgetOfMpm, WallsAndTransfersThatSmoothTakeEnergy) {
  for (const EnergyBudget& budget :
       {budget_of<BSpline<2>, Apic, AffineDensity>(), budget_of<BSpline<2>, Xpic<5>, AffineDensity>()}) {
    EXPECT_LT(budget.transfer, -0.1 * potential);
    EXPECT_LT(budget.walls, 0);
    EXPECT_LT(budget.smoothing, 0);
    EXPECT_LT(std::abs(budget.pressure), -budget.transfer);
  }
}

}  // namespace budget_test
}  // namespace touchstone::mpm
