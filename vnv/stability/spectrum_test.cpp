#include "vnv/stability/spectrum.hpp"

#include "solvers/mpm/printed/mpm.hpp"
#include "vnv/stability/critical_step.hpp"
#include "vnv/stability/lattice_starts.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::vnv {
namespace {

/// Velocities along x that diffuse from each particle to its four neighbours, `rate` of the difference a step, by
/// Adams-Bashforth steps of second order: what the last step did is remembered, and nobody sees it.
struct Diffusing {
  Scene<Newtonian> of;
  int across;
  double rate;
  Samples now;
  Scalars last = Scalars();
  long count = 0;

  Diffusing(const RestingLattice& lattice, const Start& start, double rate_of_step)
      : of(lattice.scene(start)), across(lattice.across()), rate(rate_of_step) {
    const Vectors places = touchstone::lattice(of.filled, RestingLattice::spacing).places();
    now = {0, of.start.places_on(places), Vectors::Zero(2, places.cols())};
    for (Eigen::Index p = 0; p < places.cols(); ++p) now.v.col(p) = of.start.velocity_at(now.x.col(p));
    now.density = Scalars::Constant(places.cols(), RestingLattice::density);
    now.mass = now.pressure = Scalars::Ones(places.cols());
  }
  void step() {
    Scalars change(now.size());
    for (int row = 0; row < across; ++row)
      for (int column = 0; column < across; ++column) {
        const auto v = [&](int dx, int dy) {
          return now.v(0, ((row + dy + across) % across) * across + (column + dx + across) % across);
        };
        change[row * across + column] = rate * (v(1, 0) + v(-1, 0) + v(0, 1) + v(0, -1) - 4 * v(0, 0));
      }
    now.v.row(0) += (count == 0 ? change : Scalars(1.5 * change - 0.5 * last)).matrix().transpose();
    last = change;
    now.time = static_cast<double>(++count);
  }
  const Scene<Newtonian>& scene() const { return of; }
  double time() const { return now.time; }
  double time_step() const { return 1; }
  long steps() const { return count; }
  Eigen::Index particles() const { return now.size(); }
  Eigen::Index boundary_particles() const { return 0; }
  Extremes extremes() const { return {0, of.fluid.density}; }
  void change_time_step(double) { FAIL() << "the lattice has a step of its own"; }
  Samples samples() const { return now; }
};

OnLattice diffusing(double rate) {
  return [=](const RestingLattice& lattice, const Start& start) {
    return simulating(
        {.name = "diffusing"}, [=](const Level&, double) { return Diffusing(lattice, start, rate); },
        [](const Level&) { return 1.0; });
  };
}

OnLattice linear_hats() {
  return [](const RestingLattice& lattice, const Start& start) {
    return simulating(
        {.name = "mpm"},
        [scene = lattice.scene(start)](const Level& level, double time_step) {
          return mpm::printed<mpm::PrescribedMotion>(
              scene, {.cell = level.cell, .spacing = level.spacing, .time_step = time_step});
        },
        [](const Level&) { return 1e-3; });
  };
}

TEST(Spectrum, KnowsWhatAMethodRemembersWithoutShowingIt) {
  for (const double rate : {0.1, 0.14}) {
    // Of the shortest wave, on which a step multiplies by -8 rate: lambda² - (1 + 3/2 m) lambda + m/2 = 0.
    const double m = -8 * rate, half = (1 + 1.5 * m) / 2;
    const double expected = std::abs(half) + std::sqrt(half * half - m / 2);
    const Spectrum found = spectrum(diffusing(rate), {.cells = 6}, 1);
    EXPECT_NEAR(found.radius, std::max(1.0, expected), 1e-5) << rate;
    if (expected > 1) {
      EXPECT_EQ(found.wave, Vec2(1, 1));
    }
  }
}

TEST(Spectrum, OfSeveralStepsTakenForOneIsStillThatOfAStep) {
  const double one = spectrum(diffusing(0.14), {.cells = 6}, 1).radius;
  ASSERT_GT(one, 1.1);
  EXPECT_NEAR(spectrum(diffusing(0.14), {.cells = 6}, 1, 3).radius, one, 1e-5);
}

TEST(Spectrum, HasTheClosedFormOfLinearHatsWithOneParticleInACell) {
  // Nodes see a wave of particles by cos(k/2) cos(l/2), particles its slope by 2 sin(k/2) cos(l/2) / cell: sound of
  // frequency omega <= c / cell, and symplectic steps bear omega dt <= 2.
  EXPECT_NEAR(critical_courant(linear_hats(), {.cells = 8}), 2, 0.01);
}

TEST(Spectrum, AgreesWithTheGrowthOfNoise) {
  const RestingLattice lattice{.cells = 8, .points = 2};
  const double courant = 1.9;
  const double growth = growth_per_step(simulate(linear_hats(), lattice, noisy(lattice, 1e-8), courant),
                                        {.low = 0, .high = 0, .speed_limit = 1e-3 * RestingLattice::sound_speed});
  EXPECT_NEAR(std::log(growth) / std::log(spectrum(linear_hats(), lattice, courant).radius), 1,
              0.05);  // others grow too
}

TEST(Spectrum, RefusesEndsThatBracketNothing) {
  EXPECT_THROW(critical_courant(linear_hats(), {.cells = 4}, 1, 0.1, 0.5), std::invalid_argument);
  EXPECT_THROW(critical_courant(linear_hats(), {.cells = 4}, 1, 3, 8), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::vnv
