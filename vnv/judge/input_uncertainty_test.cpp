#include "vnv/judge/input_uncertainty.hpp"

#include "vnv/files/data_folder.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/record/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace touchstone::vnv {
namespace input_uncertainty_test {

const UncertainInput speed{.name = "gate speed", .value = 3, .half_width = 0.3};
const UncertainInput height{.name = "height", .value = 0.3, .half_width = 0.002, .is_deviation = true};

TEST(InputUncertainty, OfARectangularInputIsTheHalfWidthByTheRootOfThree) {
  EXPECT_NEAR(speed.standard(), 0.17320508, 1e-8);
  EXPECT_EQ(height.standard(), 0.002);
}

TEST(InputUncertainty, IsTheRootOfTheSumOfSquaresOfSlopesTimesUncertainties) {
  // S = 2 v² has slope 4 v = 12 at 3, exactly so by central differences; S = -1000 h.
  const Sensitivity by_speed = sensitivity(speed, {2.7, 2 * 2.7 * 2.7}, {3.3, 2 * 3.3 * 3.3});
  const Sensitivity by_height = sensitivity(height, {0.298, -298}, {0.302, -302});
  EXPECT_NEAR(by_speed.slope, 12, 1e-12);
  EXPECT_NEAR(by_speed.part, 12 * 0.17320508, 1e-6);
  EXPECT_NEAR(by_height.slope, -1000, 1e-9);
  EXPECT_NEAR(by_height.part, 2, 1e-12);
  EXPECT_NEAR(input_uncertainty({by_speed, by_height}), std::sqrt(4.32 + 4), 1e-9);  // 12² 0.3² / 3 = 4.32
}

TEST(InputUncertainty, IsUnknownWithoutAnyPartOrWhereOneIsNoNumber) {
  EXPECT_TRUE(std::isnan(input_uncertainty({})));
  EXPECT_TRUE(std::isnan(input_uncertainty({{"a", 1, 1}, {"b", not_a_number, not_a_number}})));
  EXPECT_TRUE(std::isnan(sensitivity(speed, {1, not_a_number}, {2, 1}).part));
  EXPECT_THROW(sensitivity(speed, {3.3, 1}, {2.7, 1}), std::invalid_argument);
}

TEST(InputUncertainty, IsReadFromTheTableOfAnExperiment) {
  const auto inputs = read_inputs(data_folder() / "experiments/lobovsky_2014_inputs_300.csv");
  EXPECT_EQ(input_named("gate speed", inputs).value, 3.46);
  EXPECT_EQ(input_named("gate speed", inputs).unit, "m/s");
  EXPECT_FALSE(input_named("column height", inputs).is_deviation);
  EXPECT_TRUE(input_named("column height", inputs).basis.starts_with("estimate: "));
  EXPECT_THROW(input_named("wind", inputs), std::invalid_argument);
}

}  // namespace input_uncertainty_test
}  // namespace touchstone::vnv
