#include "solvers/integrators/adams_bashforth.hpp"
#include "solvers/integrators/kick_drift_kick.hpp"
#include "solvers/integrators/predictor_corrector.hpp"
#include "solvers/stepping/laps.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone {
namespace {

/// A standing sound wave in one particle, density [kg/m³] and velocity along x [m/s], at one radian a second, under a
/// body force that grows with time [m/s³].
class SoundWave {
 public:
  explicit SoundWave(double growth_of_force = 0) : growth_(growth_of_force) {
    all_.fluid = 1;
    for (Scalars* field : {&all_.x, &all_.y, &all_.vx, &all_.vy, &all_.rho, &all_.ax, &all_.ay, &all_.drho})
      field->setZero(1);
    all_.past.assign(6, Scalars::Zero(1));
    all_.rho = 1;
  }
  FluidState& state() { return all_; }
  int threads() const { return 1; }
  void find_density_rate(double, const Laps&) {
    all_.drho = -all_.vx;
    ++evaluations_;
  }
  void find_accelerations(double time, const Laps&) {
    all_.ax = all_.rho + growth_ * time;
    ++evaluations_;
  }
  void find_rates(double time, const Laps&) {
    all_.drho = -all_.vx;
    all_.ax = all_.rho + growth_ * time;
    ++evaluations_;
  }
  int evaluations() const { return evaluations_; }

 private:
  FluidState all_;
  double growth_;
  int evaluations_ = 0;
};

template <class Integrator>
SoundWave after(double end, int steps, double growth_of_force = 0) {
  SoundWave wave(growth_of_force);
  Integrator integrator;
  for (int k = 0; k < steps; ++k) integrator.step(wave, k * end / steps, end / steps, no_laps);
  return wave;
}

/// rho = cos t + sin t - t, v = 1 - cos t + sin t, x = 1 - cos t + t - sin t where the force grows by 1 m/s³.
template <class Integrator>
double error(int steps) {
  SoundWave wave = after<Integrator>(2, steps, 1);
  const FluidState& all = wave.state();
  const double sine = std::sin(2), cosine = std::cos(2);
  return std::abs(all.rho[0] - cosine - sine + 2) + std::abs(all.vx[0] - 1 + cosine - sine) +
         std::abs(all.x[0] - 3 + cosine + sine);
}

template <class Integrator>
double order() {
  return std::log2(error<Integrator>(1600) / error<Integrator>(3200));
}

/// Largest density after many steps of a phase.
template <class Integrator>
double loudness(double phase) {
  constexpr int steps = 4000;
  return std::abs(after<Integrator>(phase * steps, steps).state().rho[0]);
}

TEST(Integrators, AreOfSecondOrderAlsoUnderAForceThatChanges) {
  EXPECT_NEAR(order<PredictorCorrector>(), 2, 0.05);
  EXPECT_NEAR(order<AdamsBashforth>(), 2, 0.05);
  EXPECT_NEAR(order<KickDriftKick>(), 2, 0.05);
}

TEST(Integrators, AdamsBashforthEvaluatesOnceAStepOnceItHasStarted) {
  EXPECT_EQ(after<AdamsBashforth>(1, 100).evaluations(), 102);
  EXPECT_EQ(after<PredictorCorrector>(1, 100).evaluations(), 200);
  EXPECT_EQ(after<KickDriftKick>(1, 100).evaluations(), 201);
}

/// As `error`, with steps of another length in the second half of the time.
double error_with_another_step(int steps, double ratio) {
  SoundWave wave;
  AdamsBashforth integrator;
  double time = 0;
  for (const auto& [count, dt] :
       {std::pair{steps, 1.0 / steps}, std::pair{static_cast<int>(steps / ratio), ratio / steps}})
    for (int k = 0; k < count; ++k, time += dt) integrator.step(wave, time, dt, no_laps);
  return std::abs(wave.state().rho[0] - std::cos(2)) + std::abs(wave.state().vx[0] - std::sin(2));
}

TEST(Integrators, AdamsBashforthStartsAnewWhenItsStepChangesAndKeepsItsOrder) {
  for (const double ratio : {0.8, 1.25})
    EXPECT_GT(std::log2(error_with_another_step(400, ratio) / error_with_another_step(800, ratio)), 2.8) << ratio;
}

TEST(Integrators, AreStableUpToThePhaseTheyPromise) {
  EXPECT_LT(loudness<AdamsBashforth>(0.71), 1);
  EXPECT_FALSE(loudness<AdamsBashforth>(0.74) < 10);  // or no number
  EXPECT_LT(loudness<KickDriftKick>(1.95), 10);
  EXPECT_FALSE(loudness<KickDriftKick>(2.05) < 10);
}

TEST(Integrators, PredictorCorrectorGrowsByAnEighthOfThePhaseToTheFourth) {
  SoundWave wave = after<PredictorCorrector>(0.1 * 4000, 4000);
  const double energy = std::pow(wave.state().rho[0], 2) + std::pow(wave.state().vx[0], 2);
  EXPECT_NEAR(std::log(energy) / 2 / 4000, std::pow(0.1, 4) / 8, 0.02 * std::pow(0.1, 4) / 8);
}

}  // namespace
}  // namespace touchstone
