#include "reference/shear_wave.hpp"

#include "reference/calculus.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace touchstone::reference {
namespace shear_wave_test {

constexpr ShearWave wave{.L = 2e-3, .U = 0.5, .nu = 1e-6};

TEST(ShearWave, SolvesItsEquation) {
  for (const double t : {0.05, 0.2})
    for (const double y : {1e-4, 5e-4, 1.7e-3}) {
      const auto shear = [=](double place) { return slope([=](double z) { return wave(z, t); }, place, 1e-5); };
      const double change = slope([=](double s) { return wave(y, s); }, t, 1e-3);
      EXPECT_NEAR(change, wave.nu * slope(shear, y, 1e-5), 1e-5 * wave.U * wave.decay_rate());
    }
}

TEST(ShearWave, StartsAsASineAndRepeats) {
  EXPECT_DOUBLE_EQ(wave(wave.L / 4, 0), wave.U);
  EXPECT_NEAR(wave(wave.L / 4 + 3 * wave.L, 0.1), wave(wave.L / 4, 0.1), 1e-14);
}

TEST(ShearWave, LosesTheSameShareInEqualTimes) {
  EXPECT_NEAR(wave(3e-4, 0.3) / wave(3e-4, 0.2), wave(3e-4, 0.1) / wave(3e-4, 0), 1e-14);
}

TEST(ShearWave, RefusesWhatIsNoWave) {
  EXPECT_THROW(ShearWave({.L = -1, .U = 1, .nu = 1})(0, 0), std::domain_error);
  EXPECT_THROW(ShearWave({.L = 1, .U = 1, .nu = 0})(0, 0), std::domain_error);
  EXPECT_THROW(wave(0, -1), std::domain_error);
  EXPECT_THROW(wave(std::numeric_limits<double>::infinity(), 0), std::domain_error);
}

}  // namespace shear_wave_test
}  // namespace touchstone::reference
