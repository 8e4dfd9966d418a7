#include "vnv/run.hpp"

#include "solvers/fluids/tait.hpp"
#include "vnv/stability/critical_step.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv {
namespace {

/// Particles that move at 1 m/s, or, beyond a critical step, grow faster by a tenth each step.
struct Straight {
  double dt = 0.1, critical = 1, speed = 1;
  long count = 0;
  double blow_up_at = 1e300;  // s

  void step() {
    ++count;
    if (dt > critical) speed *= 1.1;
    if (time() > blow_up_at) speed = std::nan("");
  }
  double time() const { return static_cast<double>(count) * dt; }
  double time_step() const { return dt; }
  long steps() const { return count; }
  Scene<Tait> scene() const { return {.domain = {}, .fluid = {.density = 1, .bulk_modulus = 1e3}, .filled = {}}; }
  Eigen::Index particles() const { return 2; }
  Eigen::Index boundary_particles() const { return 0; }
  Samples samples() const {
    Samples s{time(), Vectors::Constant(2, 2, time()), Vectors::Constant(2, 2, speed)};
    s.mass = s.density = s.pressure = Scalars::Ones(2);
    return s;
  }
};

TEST(Record, SamplesAtTheAskedTimesAndWatchesInBetween) {
  const auto run = record(
      [] { return Straight{}; },
      {.times = {0.5, 2}, .watch = {.every = 0.2, .see = [](const Samples& s) { return std::vector{s.x(0, 0)}; }}});
  ASSERT_EQ(run.samples.size(), 2u);
  EXPECT_NEAR(run.samples[0].time, 0.5, 1e-12);
  EXPECT_NEAR(run.samples[1].time, 2, 1e-12);
  ASSERT_EQ(run.history.time.size(), 11u);
  EXPECT_NEAR(run.history.seen[3][0], 0.6, 1e-12);
  EXPECT_TRUE(run.summary.finished);
  EXPECT_EQ(run.summary.cost.steps, 20);
  EXPECT_NE(run.at(0.5), nullptr);
  EXPECT_EQ(run.at(1), nullptr);
}

TEST(Record, KeepsWhatWasSampledBeforeARunDiverged) {
  const auto run = record([] { return Straight{.blow_up_at = 1}; }, {.times = {0.5, 2}});
  EXPECT_FALSE(run.summary.finished);
  EXPECT_EQ(run.samples.size(), 1u);
  EXPECT_NE(run.summary.outcome.find("diverged at step 11, t = 1.1 s, particle 0"), std::string::npos)
      << run.summary.outcome;
}

TEST(CriticalStep, IsBracketedByBisection) {
  const CriticalStep found = critical_step([](double dt) { return Straight{.dt = dt, .critical = 0.37}; },
                                           {.low = 0.01, .high = 10, .steps = 200, .speed_limit = 100});
  EXPECT_LE(found.low, 0.37);
  EXPECT_GT(found.high, 0.37);
  EXPECT_LE(found.high / found.low, 1.01);
}

TEST(CriticalStep, RefusesEndsThatBracketNothing) {
  const auto solver = [](double dt) { return Straight{.dt = dt, .critical = 0.37}; };
  EXPECT_THROW(critical_step(solver, {.low = 0.01, .high = 0.1, .steps = 200, .speed_limit = 100}),
               std::invalid_argument);
  EXPECT_THROW(critical_step(solver, {.low = 1, .high = 10, .steps = 200, .speed_limit = 100}), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::vnv
