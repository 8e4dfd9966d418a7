#include "vnv/record/diagnosis.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv {
namespace diagnosis_test {

TEST(AFittedValue, HasTheDigitsOfItsInterval) {
  EXPECT_EQ(in_digits_of_interval(-5.382, 1.3), "-5.4 ± 1.3");
  EXPECT_EQ(in_digits_of_interval(4.9976, 0.02512), "4.998 ± 0.025");
  EXPECT_EQ(in_digits_of_interval(46.23, 4.2), "46 ± 4");
  EXPECT_EQ(in_digits_of_interval(0.3004, 1e-9), "0.3004 ± 0.0001") << "of four digits at most";
  EXPECT_EQ(in_digits_of_interval(123456, 7890), "123456 ± 7890");
  EXPECT_EQ(in_digits_of_interval(0, 0), "0 ± 0");
}

TEST(AFittedValue, OfAMistakeHasNoInterval) {
  EXPECT_EQ(in_digits({"viscosity", "%", 5.38, 0.13}), "5.38 ± 0.13");
  EXPECT_EQ(in_digits({"at rest", "%", -100, 0}), "-100");
  EXPECT_EQ(in_digits({"mirrored along y", "", 1, 0}), "");
}

}  // namespace diagnosis_test
}  // namespace touchstone::vnv
