/// An exact solution is the same in any units: with all that it is given in other units of length, time and mass, all
/// that it says is in these. A length of 1 m hides the power with which it stands in a formula.

#include "reference/couette.hpp"
#include "reference/dam_front.hpp"
#include "reference/elliptic_drop.hpp"
#include "reference/hydrostatic.hpp"
#include "reference/manufactured.hpp"
#include "reference/oscillating_poiseuille.hpp"
#include "reference/poiseuille.hpp"
#include "reference/rotating_patch.hpp"
#include "reference/shear_wave.hpp"
#include "reference/standing_wave.hpp"
#include "reference/stokes.hpp"
#include "reference/taylor_green.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::reference {
namespace {

/// How many units of each kind a metre, a second and a kilogramme are.
struct Units {
  double m = 1, s = 1, kg = 1;

  double speed() const { return m / s; }
  double acceleration() const { return m / s / s; }
  double viscosity() const { return m * m / s; }  // kinematic
  double density() const { return kg / (m * m * m); }
  double pressure() const { return kg / (m * s * s); }
};
constexpr Units si{}, others{.m = 1.7, .s = 0.6, .kg = 2.3};

/// `said` gives a number in units, and how large one of SI is in them.
template <class Said>
void expect_the_same(const Said& said) {
  const auto [in_si, one] = said(si);
  const auto [in_others, larger] = said(others);
  EXPECT_NE(in_si, 0);
  EXPECT_NEAR(in_others / larger, in_si / one, 1e-9 * std::abs(in_si));
}

TEST(AnExactSolution, OfChannelsIsTheSameInOtherUnits) {
  for (const double t : {0.002, 0.1, 0.4}) {
    expect_the_same([&](const Units& u) {
      return std::pair(Couette{.H = 0.8 * u.m, .V = 0.3 * u.speed(), .nu = 0.9 * u.viscosity()}(0.5 * u.m, t * u.s),
                       u.speed());
    });
    expect_the_same([&](const Units& u) {
      return std::pair(
          Poiseuille{.H = 0.8 * u.m, .F = 0.3 * u.acceleration(), .nu = 0.9 * u.viscosity()}(0.3 * u.m, t * u.s),
          u.speed());
    });
    expect_the_same([&](const Units& u) {
      return std::pair(StokesFirst{.V = 0.3 * u.speed(), .nu = 0.9 * u.viscosity()}(0.1 * u.m, t * u.s), u.speed());
    });
    expect_the_same([&](const Units& u) {
      return std::pair(
          StokesSecond{.V = 0.3 * u.speed(), .omega = 5 / u.s, .nu = 0.9 * u.viscosity()}(0.1 * u.m, t * u.s),
          u.speed());
    });
    expect_the_same([&](const Units& u) {
      return std::pair(OscillatingPoiseuille{.H = 0.8 * u.m,
                                             .F = 0.3 * u.acceleration(),
                                             .omega = 5 / u.s,
                                             .nu = 0.9 * u.viscosity()}(0.3 * u.m, t * u.s),
                       u.speed());
    });
  }
}

TEST(AnExactSolution, OfWavesIsTheSameInOtherUnits) {
  expect_the_same([](const Units& u) {
    return std::pair(ShearWave{.L = 0.8 * u.m, .U = 0.3 * u.speed(), .nu = 0.09 * u.viscosity()}(0.3 * u.m, 0.2 * u.s),
                     u.speed());
  });
  const auto swell = [](const Units& u) {
    return StandingWave{
        .L = 3 * u.m, .a = 0.02 * u.m, .h = 0.7 * u.m, .g = 9.8 * u.acceleration(), .nu = 0.01 * u.viscosity()};
  };
  expect_the_same([&](const Units& u) { return std::pair(swell(u).surface(0.4 * u.m, 0.3 * u.s), u.m); });
  expect_the_same([&](const Units& u) { return std::pair(swell(u).v_x(0.4 * u.m, 0.5 * u.m, 0.3 * u.s), u.speed()); });
  expect_the_same([&](const Units& u) { return std::pair(swell(u).v_y(0.4 * u.m, 0.5 * u.m, 0.3 * u.s), u.speed()); });
}

TEST(AnExactSolution, OfVorticesIsTheSameInOtherUnits) {
  const auto vortices = [](const Units& u) {
    return TaylorGreen{.L = 0.8 * u.m, .U = 0.3 * u.speed(), .nu = 0.09 * u.viscosity(), .rho = 1.4 * u.density()};
  };
  expect_the_same(
      [&](const Units& u) { return std::pair(vortices(u).v_x(0.13 * u.m, 0.31 * u.m, 0.2 * u.s), u.speed()); });
  expect_the_same(
      [&](const Units& u) { return std::pair(vortices(u).v_y(0.13 * u.m, 0.31 * u.m, 0.2 * u.s), u.speed()); });
  expect_the_same(
      [&](const Units& u) { return std::pair(vortices(u).p(0.13 * u.m, 0.31 * u.m, 0.2 * u.s), u.pressure()); });
  expect_the_same([&](const Units& u) { return std::pair(vortices(u).energy(0.2 * u.s), u.pressure()); });
  const auto chosen = [](const Units& u) {
    return Manufactured{.L = 2 * u.m,
                        .U = 1.5 * u.speed(),
                        .omega = 3 / u.s,
                        .rho0 = 1000 * u.density(),
                        .ripple = 0.1,
                        .K = 4000 * u.pressure(),
                        .mu = 30 * u.pressure() * u.s};
  };
  expect_the_same([&](const Units& u) { return std::pair(chosen(u).density(0.13 * u.m, 0.31 * u.m), u.density()); });
  expect_the_same([&](const Units& u) { return std::pair(chosen(u).pressure(0.13 * u.m, 0.31 * u.m), u.pressure()); });
  for (const std::size_t axis : {0u, 1u}) {
    expect_the_same([&](const Units& u) {
      return std::pair(chosen(u).velocity(0.13 * u.m, 0.31 * u.m, 0.2 * u.s)[axis], u.speed());
    });
    expect_the_same([&](const Units& u) {
      return std::pair(chosen(u).force(0.13 * u.m, 0.31 * u.m, 0.2 * u.s)[axis], u.acceleration());
    });
  }
}

TEST(AnExactSolution, OfAFreeSurfaceIsTheSameInOtherUnits) {
  const auto stretched = [](const Units& u) {
    return EllipticDrop{.R = 0.3 * u.m, .s0 = 80 / u.s, .rho = 900 * u.density()}.at(0.007 * u.s);
  };
  expect_the_same([&](const Units& u) { return std::pair(stretched(u).a, u.m); });
  expect_the_same([&](const Units& u) { return std::pair(stretched(u).b, u.m); });
  expect_the_same([&](const Units& u) { return std::pair(stretched(u).s, 1 / u.s); });
  expect_the_same([&](const Units& u) { return std::pair(stretched(u).p(0.1 * u.m, 0.05 * u.m), u.pressure()); });
  const auto turning = [](const Units& u) {
    return RotatingPatch{.L = 0.8 * u.m, .omega = 2 / u.s, .rho = 900 * u.density()};
  };
  expect_the_same([&](const Units& u) { return std::pair(turning(u).p(0.1 * u.m, 0.2 * u.m), u.pressure()); });
  expect_the_same([&](const Units& u) { return std::pair(turning(u).mass(), u.kg / u.m); });
  expect_the_same([&](const Units& u) { return std::pair(turning(u).kinetic_energy(), u.pressure() * u.m * u.m); });
  const auto water_at_rest = [](const Units& u) {
    return Hydrostatic{
        .rho0 = 900 * u.density(), .K = 14300 * u.pressure(), .g = 9.8 * u.acceleration(), .h = 0.7 * u.m};
  };
  expect_the_same([&](const Units& u) { return std::pair(water_at_rest(u).p(0.2 * u.m), u.pressure()); });
  expect_the_same([&](const Units& u) { return std::pair(water_at_rest(u).rho(0.2 * u.m), u.density()); });
  expect_the_same([&](const Units& u) { return std::pair(water_at_rest(u).mass(), u.kg / u.m / u.m); });
  expect_the_same([](const Units& u) {
    return std::pair(RitterFront{.g = 9.8 * u.acceleration(), .h0 = 0.7 * u.m, .l0 = 0.4 * u.m}(0.1 * u.s), u.m);
  });
}

}  // namespace
}  // namespace touchstone::reference
