#include "vnv/measures/field_errors.hpp"

#include "vnv/measures/decay.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::vnv {
namespace field_errors_test {

Vec2 turning(const Vec2& x, double t) { return Vec2(-x.y(), x.x()) * std::exp(-t); }
double rising(const Vec2& x, double t) { return 3 * x.x() + t; }

/// Nine particles that move just as the truth says, the last of three times the volume of the others.
Samples turning_samples(double t) {
  Samples s{t, Vectors(2, 9), Vectors(2, 9), Scalars::Ones(9), Scalars::Ones(9), Scalars(9)};
  s.mass[8] = 3;
  for (Eigen::Index p = 0; p < 9; ++p) {
    s.x.col(p) = Vec2(static_cast<double>(p % 3) - 1, static_cast<double>(p / 3) - 1);
    s.v.col(p) = turning(s.x.col(p), t);
    s.pressure[p] = rising(s.x.col(p), t);
  }
  return s;
}

double value_of(const std::vector<Value>& errors, const Quantity& quantity) {
  for (const Value& e : errors)
    if (e.quantity == quantity) return e.value;
  return not_a_number;
}

const Level level{.name = "M1", .spacing = 1};

TEST(VelocityErrors, OfTheTruthAreNone) {
  const vnv::Run run{.samples = {turning_samples(0.5)}};
  const auto errors = velocity_errors(turning)(level, run);
  EXPECT_EQ(value_of(errors, l2_velocity), 0);
  EXPECT_EQ(value_of(errors, linf_velocity), 0);
}

TEST(VelocityErrors, CountEachParticleByItsVolume) {
  Samples s = turning_samples(0);
  s.v.col(8) += Vec2(0.3, -0.4);  // the truth there is of length sqrt(2)
  const auto errors = velocity_errors(turning)(level, vnv::Run{.samples = {s}});
  EXPECT_NEAR(value_of(errors, l2_velocity), 100 * std::sqrt(3 * 0.25 / (4 * 1 + 3 * 2 + 3 * 2)), 1e-12);
  EXPECT_NEAR(value_of(errors, linf_velocity), 100 * 0.5 / std::sqrt(2), 1e-12);
}

TEST(VelocityErrors, OfWhatIsNoNumberAreNoNumbers) {
  Samples s = turning_samples(0);
  s.v(0, 4) = not_a_number;
  const auto errors = velocity_errors(turning)(level, vnv::Run{.samples = {s}});
  EXPECT_TRUE(std::isnan(value_of(errors, l2_velocity)));
  EXPECT_TRUE(std::isnan(value_of(errors, linf_velocity)));
}

TEST(PressureErrors, DoNotSeeAPressureThatIsTheSameEverywhere) {
  Samples s = turning_samples(0.5);
  s.pressure += 1e3;
  EXPECT_NEAR(value_of(pressure_errors(rising)(level, vnv::Run{.samples = {s}}), l2_pressure), 0, 1e-11);
}

TEST(PressureErrors, SeeAPressureThatIsTwiceTheTruth) {
  Samples s = turning_samples(0);
  s.pressure *= 2;
  EXPECT_NEAR(value_of(pressure_errors(rising)(level, vnv::Run{.samples = {s}}), l2_pressure), 100, 1e-10);
}

TEST(KineticEnergy, IsHalfTheMassTimesTheSpeedSquared) {
  EXPECT_NEAR(kinetic_energy(turning_samples(0)), (4 * 1 + 3 * 2 + 3 * 2) / 2.0, 1e-14);
}

TEST(RateOfDecay, OfAnExponentialIsItsRate) {
  const std::vector<double> times{0, 0.1, 0.4, 1};
  std::vector<double> values;
  for (const double t : times) values.push_back(3 * std::exp(-2.5 * t));
  EXPECT_NEAR(rate_of_decay(times, values), 2.5, 1e-13);
}

TEST(RateOfDecay, OfWhatDoesNotDecayExponentiallyIsNotANumber) {
  EXPECT_TRUE(std::isnan(rate_of_decay({0, 1, 2}, {1, 0, 0.2})));
  EXPECT_TRUE(std::isnan(rate_of_decay({0, 1, 2}, {1, -1, 0.2})));
  EXPECT_TRUE(std::isnan(rate_of_decay({0}, {1})));
}

TEST(DecayOfEnergy, IsComparedWithTheExactRate) {
  vnv::Run run{.summary = {.end_time = 1, .finished = true}};
  run.history = {{0, 0.5, 1}, {{7, 1}, {7, std::exp(-1.1)}, {7, std::exp(-2.2)}}};
  EXPECT_NEAR(value_of(decay_of_energy(1, 2)(level, run), decay_error), 10, 1e-10);
}

TEST(DecayOfEnergy, OfARunThatDivergedIsNotTold) {
  vnv::Run run{.summary = {.end_time = 0.5, .finished = false}};
  run.history = {{0, 0.5}, {{1}, {2}}};
  EXPECT_TRUE(decay_of_energy(0, 2)(level, run).empty());
}

}  // namespace field_errors_test
}  // namespace touchstone::vnv
