#include "vnv/flows/lid_driven.hpp"

#include "reference/lid_driven_cavity.hpp"
#include "vnv/files/data_folder.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv::lid_driven {
namespace lid_driven_test {

/// Root of the mean square of the table's distance from the computed flow [% of the lid's speed].
double distance(const Centreline& line, const reference::LidDrivenCavity& cavity) {
  double sum = 0;
  for (std::size_t k = 0; k < line.at.size(); ++k) {
    const double exact = line.direction == Centreline::vertical ? cavity.u(0.5, line.at[k]) : cavity.v(line.at[k], 0.5);
    sum += std::pow(line.velocity[k] - exact, 2);
  }
  return 100 * std::sqrt(sum / static_cast<double>(line.at.size()));
}

/// Ghia, Ghia & Shin are quoted by everybody, and are no exact solution: an error of half a per cent may be theirs.
TEST(TablesOfGhia, AreOffTheComputedFlowByWhatTheirDataFileSays) {
  const reference::LidDrivenCavity at_100(100, 40), at_400(400, at_100);
  const auto off = [&](Centreline::Direction direction, int Re) {
    return distance(ghia_centreline(data_folder(), direction, Re), Re == 100 ? at_100 : at_400);
  };
  EXPECT_NEAR(off(Centreline::vertical, 100), 0.254, 0.002);
  EXPECT_NEAR(off(Centreline::horizontal, 100), 0.509, 0.002);
  EXPECT_NEAR(off(Centreline::vertical, 400), 0.141, 0.002);
  EXPECT_NEAR(off(Centreline::horizontal, 400), 0.326, 0.002) << "without the misprint";
}

}  // namespace lid_driven_test
}  // namespace touchstone::vnv::lid_driven
