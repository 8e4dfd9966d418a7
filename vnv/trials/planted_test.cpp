// A fault is planted in one particle at one step; the run has to end with its name.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/mpm/printed/mpm.hpp"
#include "vnv/run/run.hpp"
#include "vnv/run/state_check.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace touchstone::vnv {
namespace {

const Scene<Newtonian> still_water{
    .domain = {.box = {.high = {1, 1}}, .periodic_x = true, .periodic_y = true},
    .fluid = {{.density = 1000, .bulk_modulus = 1e5}, 1e-3},
    .filled = {.high = {1, 1}},
};

auto still_solver(double time_step = 1e-4) {
  return mpm::printed<mpm::PrescribedMotion>(still_water, {.cell = 0.1, .spacing = 0.1, .time_step = time_step});
}
using StillSolver = decltype(still_solver());

/// A solver of which one particle is spoilt from a step on.
struct Planted {
  StillSolver solver = still_solver();
  long from = 0;
  std::function<void(Samples&)> spoil;

  void step() { solver.step(); }
  const auto& scene() const { return solver.scene(); }
  double time() const { return solver.time(); }
  double time_step() const { return solver.time_step(); }
  long steps() const { return solver.steps(); }
  Eigen::Index particles() const { return solver.particles(); }
  Eigen::Index boundary_particles() const { return 0; }
  Extremes extremes() const { return solver.extremes(); }
  void change_time_step(double time_step) { solver.change_time_step(time_step); }
  Samples samples() const {
    Samples s = solver.samples();
    if (steps() >= from) spoil(s);
    return s;
  }
};

constexpr Eigen::Index victim = 37;
constexpr long planted_at = 1234;

std::string ending_with(const std::function<void(Samples&)>& spoil) {
  const auto run = simulate([&] { return Planted{.from = planted_at, .spoil = spoil}; }, {.times = {0.1, 0.3}});
  EXPECT_FALSE(run.summary.finished);
  EXPECT_EQ(run.samples.size(), 1u);
  return run.summary.outcome;
}

void expect_named(const std::string& outcome, const std::string& quantity) {
  EXPECT_NE(outcome.find("diverged at step 1234, t = 0.1234 s, particle 37 at (0.75, 0.35) m: " + quantity),
            std::string::npos)
      << outcome;
}

TEST(StateCheck, NamesTheStepAndParticleOfAVelocityThatIsNoNumber) {
  expect_named(ending_with([](Samples& s) { s.v(1, victim) = std::nan(""); }), "speed [m/s] = nan");
}
TEST(StateCheck, NamesTheStepAndParticleOfASpeedBeyondSound) {
  expect_named(ending_with([](Samples& s) { s.v(0, victim) = 1e3; }), "speed [m/s] = 1000, expected at most 5 times");
}
TEST(StateCheck, NamesTheStepAndParticleOfADensityThatNoFluidHas) {
  expect_named(ending_with([](Samples& s) { s.density[victim] = -2; }), "density [kg/m³] = -2, expected 10 to 10000");
  expect_named(ending_with([](Samples& s) { s.density[victim] = 2e4; }), "density [kg/m³] = 20000");
}
TEST(StateCheck, NamesTheStepAndParticleOfAPlaceThatIsNoNumber) {
  EXPECT_NE(ending_with([](Samples& s) {
              s.x(0, victim) = std::nan("");
            }).find("diverged at step 1234, t = 0.1234 s, particle 37 at (nan, 0.35) m"),
            std::string::npos);
}
TEST(StateCheck, NoticesLostMass) {
  const std::string ending = ending_with([](Samples& s) { s.mass[victim] *= 0.99; });
  EXPECT_NE(ending.find("diverged at step 1234"), std::string::npos) << ending;
  EXPECT_NE(ending.find("mass [kg/m] = 999.9, expected 1000 as at the start"), std::string::npos) << ending;
}
TEST(StateCheck, NoticesALostParticle) {
  const std::string ending = ending_with([](Samples& s) {
    s.x.conservativeResize(2, s.size() - 1);
    s.v.conservativeResize(2, s.size());
  });
  EXPECT_NE(ending.find("diverged at step 1234"), std::string::npos) << ending;
  EXPECT_NE(ending.find("particles = 99, expected 100 as at the start"), std::string::npos) << ending;
}
TEST(StateCheck, NoticesEnergyThatNoFlowHas) {
  const std::string ending = ending_with([](Samples& s) { s.v.row(0).setConstant(60); });
  EXPECT_NE(ending.find("kinetic energy of all [J/m]"), std::string::npos) << ending;
}

TEST(StateCheck, EndsARunWhoseStepIsTooLongAtTheFirstStepThatIsNoFlow) {
  Scene<Newtonian> stirred = still_water;
  stirred.start.velocity = [](const Vec2& x) { return Vec2(1e-3 * std::sin(40 * x.x()), 1e-3 * std::cos(33 * x.y())); };
  const auto too_long = [&] {
    return mpm::printed<mpm::PrescribedMotion>(stirred, {.cell = 0.1, .spacing = 0.05, .time_step = 0.02});
  };
  const auto run = simulate(too_long, {.times = {20}});
  // The same without the run loop, evaluated after each step.
  auto solver = too_long();
  const StateCheck state_check(Simulation(too_long()).medium(), solver.samples());
  std::string first;
  try {
    for (;;) {
      solver.step();
      state_check.require(solver.samples(), solver.steps());
    }
  } catch (const Diverged& diverged) {
    first = diverged.what();
  }
  EXPECT_FALSE(run.summary.finished);
  EXPECT_EQ(run.summary.outcome, first);
}

}  // namespace
}  // namespace touchstone::vnv
