#include "solvers/mpm/composed/booked.hpp"

#include "solvers/mpm/composed/densities/affine_density.hpp"
#include "solvers/mpm/composed/transfers/apic.hpp"
#include "solvers/mpm/composed/transfers/flip.hpp"
#include "solvers/mpm/composed/transfers/xpic.hpp"
#include "solvers/mpm/shapes/b_spline.hpp"
#include "solvers/mpm/shapes/linear_hat.hpp"
#include "solvers/testing.hpp"
#include "solvers/walls/free_slip.hpp"

namespace touchstone::mpm {
namespace booked_test {

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
EnergyBook book_of() {
  Booked<Shape, Transfer, Density> simulation(dam, settings);
  for (int k = 0; k < steps; ++k) simulation.step();
  return *simulation.book;
}
template <class Shape, class Transfer, class Density>
void expect_the_same_run() {
  auto plain = composed<Shape, Transfer, Density>(dam, settings);
  Booked<Shape, Transfer, Density> booked(dam, settings);
  for (int k = 0; k < steps; ++k) plain.step(), booked.step();
  const Samples a = plain.samples(), b = booked.samples();
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
  EXPECT_TRUE((a.density == b.density).all());
}

TEST(EnergyBookOfMpm, KeepingItChangesNoBitOfARun) {
  expect_the_same_run<BSpline<2>, Apic, AffineDensity>();
  expect_the_same_run<LinearHat, Flip, CarriedDensity>();
}

TEST(EnergyBookOfMpm, AccountsForAllEnergyButRounding) {
  for (const EnergyBook& book :
       {book_of<BSpline<2>, Apic, AffineDensity>(), book_of<BSpline<2>, Xpic<5>, AffineDensity>(),
        book_of<LinearHat, Flip, CarriedDensity>()}) {
    EXPECT_NEAR(book.start.total(), potential, 0.01 * potential);
    EXPECT_NE(book.transfer, 0);
    EXPECT_NEAR(book.residual(), 0, 1e-12 * potential);
  }
}

TEST(EnergyBookOfMpm, PartsThatAMethodDoesNotHaveAddNothing) {
  const EnergyBook book = book_of<LinearHat, Flip, CarriedDensity>();
  EXPECT_EQ(book.smoothing, 0);
  EXPECT_EQ(book.viscosity, 0);
  EXPECT_EQ(book.shifting, 0);
}

TEST(EnergyBookOfMpm, WallsAndTransfersThatSmoothTakeEnergy) {
  for (const EnergyBook& book :
       {book_of<BSpline<2>, Apic, AffineDensity>(), book_of<BSpline<2>, Xpic<5>, AffineDensity>()}) {
    EXPECT_LT(book.transfer, -0.1 * potential);
    EXPECT_LT(book.walls, 0);
    EXPECT_LT(book.smoothing, 0);
    EXPECT_LT(std::abs(book.pressure), -book.transfer);
  }
}

}  // namespace booked_test
}  // namespace touchstone::mpm
