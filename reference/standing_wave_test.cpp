#include "reference/standing_wave.hpp"

#include "reference/calculus.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::reference {
namespace standing_wave_test {

constexpr StandingWave wave{.L = 2, .a = 0.01, .h = 1, .g = 9.81, .nu = 0};
constexpr double step = 0.01;

TEST(StandingWave, LosesNoVolumeAndDoesNotTurn) {
  for (const double t : {0.1, 0.4})
    for (const double x : {0.3, 1.2})
      for (const double y : {0.2, 0.9}) {
        const double u_x = slope([=](double s) { return wave.v_x(s, y, t); }, x, step),
                     u_y = slope([=](double s) { return wave.v_x(x, s, t); }, y, step),
                     v_x = slope([=](double s) { return wave.v_y(s, y, t); }, x, step),
                     v_y = slope([=](double s) { return wave.v_y(x, s, t); }, y, step);
        EXPECT_NEAR(u_x + v_y, 0, 1e-10);
        EXPECT_NEAR(v_x - u_y, 0, 1e-10);
      }
}

TEST(StandingWave, MovesItsSurface) {
  for (const double t : {0.1, 0.4})
    EXPECT_NEAR(slope([=](double s) { return wave.surface(0.3, s); }, t, step), wave.v_y(0.3, wave.h, t), 1e-9);
}

TEST(StandingWave, HasNoPressureAtItsSurface) {  // v_t = -g grad(surface) there, to first order
  for (const double t : {0.1, 0.4})
    EXPECT_NEAR(slope([=](double s) { return wave.v_x(0.3, wave.h, s); }, t, step),
                -wave.g * slope([=](double x) { return wave.surface(x, t); }, 0.3, step), 1e-8);
}

TEST(StandingWave, StaysOnTheFloorAndBetweenItsCrests) {
  EXPECT_EQ(wave.v_y(0.3, 0, 0.2), 0);
  for (const double x : {0.0, 1.0, 2.0}) EXPECT_NEAR(wave.v_x(x, 0.5, 0.2), 0, 1e-16);
}

TEST(StandingWave, OnDeepAndOnShallowWaterHasTheKnownPeriods) {
  constexpr double pi = std::numbers::pi;
  const StandingWave deep{.L = 1, .a = 0, .h = 10, .g = 9.81, .nu = 0};
  const StandingWave shallow{.L = 100, .a = 0, .h = 0.01, .g = 9.81, .nu = 0};
  EXPECT_NEAR(2 * pi / deep.omega(), std::sqrt(2 * pi / 9.81), 1e-12);
  EXPECT_NEAR(2 * pi / shallow.omega(), 100 / std::sqrt(9.81 * 0.01), 1e-4);
}

TEST(StandingWave, LosesEnergyAtTheRateOfItsStresses) {
  // Lamb, section 348: the dissipation of a potential flow, mu times the flux of grad v² through the surface, over its
  // energy, which is on the mean in halves kinetic and potential.
  StandingWave viscous = wave;
  viscous.nu = 1e-3;
  const double t = std::numbers::pi / 2 / viscous.omega();  // all of the energy is kinetic
  const auto speed2 = [&](double x, double y) {
    return wave.v_x(x, y, t) * wave.v_x(x, y, t) + wave.v_y(x, y, t) * wave.v_y(x, y, t);
  };
  const double kinetic =
      integral([&](double x) { return integral([&](double y) { return speed2(x, y) / 2; }, 0, 1); }, 0, 2);
  const double flux =
      integral([&](double x) { return slope([&](double y) { return speed2(x, y); }, wave.h, step); }, 0, 2);
  const double mean_dissipation = viscous.nu * flux / 2;  // it goes as the kinetic energy does, half on the mean
  EXPECT_NEAR(2 * viscous.decay_rate(), mean_dissipation / kinetic, 1e-6 * viscous.decay_rate());
}

TEST(StandingWave, RefusesWhatIsNoWave) {
  EXPECT_THROW(StandingWave({.L = 0, .a = 1, .h = 1, .g = 1, .nu = 0}).surface(0, 0), std::domain_error);
  EXPECT_THROW(StandingWave({.L = 1, .a = 1, .h = 1, .g = 1, .nu = -1}).v_x(0, 0, 0), std::domain_error);
  EXPECT_THROW(wave.v_y(0, std::numeric_limits<double>::infinity(), 0), std::domain_error);
  EXPECT_THROW(wave.surface(0, -1), std::domain_error);
}

}  // namespace standing_wave_test
}  // namespace touchstone::reference
