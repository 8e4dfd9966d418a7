#include "solvers/integrators/drift_kick_drift.hpp"
#include "solvers/integrators/kick_drift_kick.hpp"
#include "solvers/integrators/symplectic.hpp"
#include "solvers/integrators/testing.hpp"

#include <gtest/gtest.h>

namespace touchstone {
namespace {

constexpr double mean = 10;  // kg/m³  keeps the density positive

template <class Integrator>
Oscillators after(double dt, int steps) {
  return moved<Integrator>(Oscillators(mean, 1), dt, steps);
}

/// rho = mean + cos t, v_x = sin t, x = 1 - cos t; y = cos t, v_y = -sin t.
template <class Integrator>
double error(int steps) {
  Oscillators wave = after<Integrator>(2.0 / steps, steps);
  const FluidState& all = wave.state();
  return std::abs(all.rho[0] - mean - std::cos(2)) + std::abs(all.vx[0] - std::sin(2)) +
         std::abs(all.x[0] - 1 + std::cos(2)) + std::abs(all.y[0] - std::cos(2)) + std::abs(all.vy[0] + std::sin(2));
}

template <class Integrator>
double order() {
  return std::log2(error<Integrator>(800) / error<Integrator>(1600));
}

TEST(VerletIntegrators, AreOfSecondOrder) {
  EXPECT_NEAR(order<DriftKickDrift>(), 2, 0.05);
  EXPECT_NEAR(order<Symplectic>(), 2, 0.05);
}

TEST(VerletIntegrators, DriftKickDriftKeepsSoundAndSpringForAHundredThousandSteps) {
  const Oscillators wave = after<DriftKickDrift>(0.5, 100000);
  EXPECT_NEAR(wave.energy_of_sound(), 1, 0.1);
  EXPECT_NEAR(wave.energy_of_spring(), 1, 0.1);
}

TEST(VerletIntegrators, DriftKickDriftIsStableUpToAPhaseOfTwo) {
  EXPECT_LT(after<DriftKickDrift>(1.95, 4000).energy_of_sound(), 100);
  EXPECT_FALSE(after<DriftKickDrift>(2.05, 4000).energy_of_sound() < 100);  // or no number
}

TEST(VerletIntegrators, SymplecticKeepsASpringButNotSound) {
  const Oscillators wave = after<Symplectic>(0.1, 4000);
  EXPECT_NEAR(wave.energy_of_spring(), 1, 0.01);
  EXPECT_NEAR(std::log(wave.energy_of_sound()) / 2 / 4000, std::pow(0.1, 4) / 8, 0.05 * std::pow(0.1, 4) / 8);
}

TEST(VerletIntegrators, EvaluateAsOftenAsTheySay) {
  EXPECT_EQ(after<DriftKickDrift>(0.01, 100).evaluations(), 300);
  EXPECT_EQ(after<Symplectic>(0.01, 100).evaluations(), 200);
}

}  // namespace
}  // namespace touchstone
