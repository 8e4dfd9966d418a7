#include "vnv/run/run.hpp"

#include "solvers/fluids/tait.hpp"
#include "solvers/stepping/clock.hpp"
#include "vnv/stability/critical_step.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv {
namespace {

/// Particles that move at 1 m/s, or, beyond a critical step, grow faster by a tenth each step.
struct Straight : Clock {
  struct Settings {
    double dt = 0.1, critical = 1, blow_up_at = 1e300;  // s
    std::function<double(double)> signal{};             // m/s  over time [s]
  };
  Settings settings;
  double speed = 1;

  Straight() : Straight(Settings{}) {}
  explicit Straight(const Settings& s) : Clock("straight", s.dt), settings(s) {}

  void step() {
    tick();
    if (time_step() > settings.critical) speed *= 1.1;
    if (time() > settings.blow_up_at) speed = std::nan("");
  }
  Scene<Tait> scene() const { return {.domain = {}, .fluid = {.density = 1, .bulk_modulus = 1e3}, .filled = {}}; }
  Eigen::Index particles() const { return 2; }
  Eigen::Index boundary_particles() const { return 0; }
  Extremes extremes() const {
    const double c = scene().fluid.sound_speed();
    return {settings.signal ? settings.signal(time()) - c : speed, scene().fluid.density};
  }
  Samples samples() const {
    Samples s{time(), Vectors::Constant(2, 2, time()), Vectors::Constant(2, 2, speed)};
    if (settings.signal && std::isfinite(speed)) s.v.colwise() = Vec2(extremes().speed, 0);
    s.mass = s.density = s.pressure = Scalars::Ones(2);
    return s;
  }
};

TEST(ARun, IsSampledAtTheAskedTimesAndMonitoredInBetween) {
  const auto run =
      simulate([] { return Straight(); },
               {.times = {0.5, 2},
                .monitor = {.interval = 0.2, .evaluate = [](const Samples& s) { return std::vector{s.x(0, 0)}; }}});
  ASSERT_EQ(run.samples.size(), 2u);
  EXPECT_NEAR(run.samples[0].time, 0.5, 1e-12);
  EXPECT_NEAR(run.samples[1].time, 2, 1e-12);
  ASSERT_EQ(run.history.time.size(), 11u);
  EXPECT_NEAR(run.history.values[3][0], 0.6, 1e-12);
  EXPECT_TRUE(run.summary.finished);
  EXPECT_EQ(run.summary.cost.steps, 20);
  EXPECT_NE(run.at(0.5), nullptr);
  EXPECT_EQ(run.at(1), nullptr);
}

TEST(ARun, KeepsWhatWasSampledBeforeItDiverged) {
  const auto run = simulate([] { return Straight({.blow_up_at = 1}); }, {.times = {0.5, 2}});
  EXPECT_FALSE(run.summary.finished);
  EXPECT_EQ(run.samples.size(), 1u);
  EXPECT_NE(run.summary.outcome.find("diverged at step 11, t = 1.1 s, particle 0"), std::string::npos)
      << run.summary.outcome;
}

/// Signals as fast as sound until 1 s, `livelier` times as fast from then until 3 s.
Straight livelier_for_a_while(double livelier, double blow_up_at = 1e300) {
  const double c = Straight().scene().fluid.sound_speed();
  return Straight({.dt = 0.001, .blow_up_at = blow_up_at, .signal = [=](double t) {
                     return t > 0.9999 && t < 2.9999 ? livelier * c : c;
                   }});
}

TEST(AdaptiveStep, FollowsTheFlowAndTakesItsOwnLengthAgainAtTheNextAskedTime) {
  const auto run = simulate([] { return livelier_for_a_while(2); }, {.times = {1, 2.0005, 3, 5}}, Stepping::adaptive);
  ASSERT_EQ(run.samples.size(), 4u);
  EXPECT_NEAR(run.samples[1].time, 2.0005, 1e-12);  // whole steps lead there, though none of 1 ms do
  EXPECT_NEAR(run.samples[2].time, 3, 1e-12);
  EXPECT_NEAR(run.samples[3].time, 5, 1e-12);
  const double shortened = std::pow(Pace::factor, 2);  // the first below 1.4 / 2
  EXPECT_EQ(run.summary.cost.steps,
            1000 + std::ceil(1.0005 / (0.001 * shortened)) + std::ceil(0.9995 / (0.001 * shortened)) + 2000);
  EXPECT_NEAR(run.value_of(shortest_step_taken), shortened, 1e-3 * shortened);
  EXPECT_EQ(run.summary.time_step, 0.001);
}

TEST(AdaptiveStep, IsTheGivenOneForAFlowWithinItsRoom) {
  const auto run = simulate([] { return livelier_for_a_while(1.39); }, {.times = {5}}, Stepping::adaptive);
  EXPECT_EQ(run.summary.cost.steps, 5000);
  EXPECT_TRUE(std::isnan(run.value_of(shortest_step_taken)));
}

TEST(AdaptiveStep, IsNotTakenWhereTheSceneSaysItsOwn) {
  EXPECT_EQ(simulate([] { return livelier_for_a_while(3); }, {.times = {5}}).summary.cost.steps, 5000);
}

TEST(AdaptiveStep, NamesTheFirstStepThatIsNoFlowAfterChanges) {
  const auto run = simulate([] { return livelier_for_a_while(2, 2.5); }, {.times = {5}}, Stepping::adaptive);
  EXPECT_FALSE(run.summary.finished);
  const double step = 4.0 / std::ceil(4.0 / (0.001 * std::pow(Pace::factor, 2)));
  const long first = 1000 + static_cast<long>(std::floor(1.5 / step)) + 1;
  EXPECT_NE(run.summary.outcome.find(fmt::format("diverged at step {}, t = ", first)), std::string::npos)
      << run.summary.outcome;
}

TEST(AdaptiveStep, HeedsNotWhatIsFastAtFewParticlesOnly) {
  /// One particle of so many is fast.
  struct Crowd : Clock {
    long count;
    explicit Crowd(long n) : Clock("crowd", 1e-3), count(n) {}
    void step() { tick(); }
    Scene<Tait> scene() const { return Straight().scene(); }
    Eigen::Index particles() const { return count; }
    Eigen::Index boundary_particles() const { return 0; }
    Extremes extremes() const { return {2 * scene().fluid.sound_speed(), 1}; }
    Samples samples() const {
      Samples s{time(), Vectors::Zero(2, count), Vectors::Zero(2, count)};
      s.mass = s.density = s.pressure = Scalars::Ones(count);
      s.v(0, count / 2) = extremes().speed;
      return s;
    }
  };
  const Simulation few{Crowd(101)}, many{Crowd(99)};
  EXPECT_EQ(Pace(few).longest(few), 1e-3);
  EXPECT_LT(Pace(many).longest(many), 0.5e-3);
}

TEST(AdaptiveStep, IsNeverShorterThanATenthOrNoNumber) {
  const Simulation simulation{Straight()};
  const Pace pace(simulation);
  EXPECT_EQ(pace.longest(1e9), 0.1 * pace.given());
  EXPECT_EQ(pace.longest(std::nan("")), 0.1 * pace.given());
  EXPECT_EQ(pace.longest(0), pace.given());
}

TEST(CriticalStep, IsBracketedByBisection) {
  const CriticalStep found = critical_step([](double dt) { return Straight({.dt = dt, .critical = 0.37}); },
                                           {.low = 0.01, .high = 10, .steps = 200, .speed_limit = 100});
  EXPECT_LE(found.low, 0.37);
  EXPECT_GT(found.high, 0.37);
  EXPECT_LE(found.high / found.low, 1.01);
}

TEST(CriticalStep, RefusesEndsThatBracketNothing) {
  const auto solver = [](double dt) { return Straight({.dt = dt, .critical = 0.37}); };
  EXPECT_THROW(critical_step(solver, {.low = 0.01, .high = 0.1, .steps = 200, .speed_limit = 100}),
               std::invalid_argument);
  EXPECT_THROW(critical_step(solver, {.low = 1, .high = 10, .steps = 200, .speed_limit = 100}), std::invalid_argument);
}

}  // namespace
}  // namespace touchstone::vnv
