#include "vnv/judge/validation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace touchstone::vnv {
namespace validation_test {

using Outcome = Validation::Outcome;

// 2² + 3² + 6² = 7², so u_val is 7 and 2 u_val is 14.
constexpr ValidationParts parts{.numerical = 2, .input = 3, .data = 6};

TEST(Validation, AgreesWhereTheErrorIsWithinTwiceTheUncertainty) {
  const Validation found = validate(110, 100, parts);
  EXPECT_EQ(found.outcome, Outcome::agrees);
  EXPECT_EQ(found.error, 10);
  EXPECT_DOUBLE_EQ(found.uncertainty, 7);
  EXPECT_EQ(words(found, "Pa"), "agrees within 2 u_val: E = 10 Pa, 2 u_val = 14 Pa (u_num 2, u_input 3, u_D 6)");
  EXPECT_EQ(validate(114, 100, parts).outcome, Outcome::agrees) << "the bound is inside";
}

TEST(Validation, FindsAModelErrorBeyondThatOfEitherSign) {
  EXPECT_EQ(words(validate(85.5, 100, parts), ""), "model error -14.5 ± 14 (u_num 2, u_input 3, u_D 6)");
  EXPECT_EQ(validate(114.01, 100, parts).outcome, Outcome::model_error);
  EXPECT_EQ(validate(110, 100, parts, 20, 1).outcome, Outcome::model_error) << "beyond u_val itself";
}

TEST(Validation, SaysNothingWhereTheUncertaintyIsMoreThanIsOfUse) {
  const Validation found = validate(110, 100, parts, 13);
  EXPECT_EQ(found.outcome, Outcome::too_uncertain);
  EXPECT_EQ(
      words(found, "Pa"),
      "uncertainty too large to judge: E = 10 Pa, 2 u_val = 14 Pa, useful up to 13 Pa (u_num 2, u_input 3, u_D 6)");
  EXPECT_EQ(validate(110, 100, parts, 14).outcome, Outcome::agrees);
  EXPECT_EQ(validate(200, 100, parts, 13).outcome, Outcome::model_error) << "stands out all the same";
  EXPECT_EQ(validate(1, 2, {.data = INFINITY}).outcome, Outcome::too_uncertain);
}

TEST(Validation, RestsOnTheKnownPartsAndSaysSo) {
  const Validation found = validate(110, 100, {.numerical = 3, .data = 4});
  EXPECT_EQ(found.uncertainty, 5);
  EXPECT_EQ(
      words(found, ""),
      "agrees within 2 u_val: E = 10, 2 u_val = 10 (u_num 3, u_D 4); u_input is unknown, so u_val is a lower bound");
  EXPECT_EQ(words(validate(110, 100, {.numerical = 3}), ""),
            "model error 10 ± 6 (u_num 3); u_input and u_D are unknown, so u_val is a lower bound");
}

TEST(Validation, OfNoNumberOrWithoutAnyUncertaintyIsNone) {
  EXPECT_EQ(words(validate(110, 100, {}), ""), "cannot be judged: E = 10, no uncertainty is known");
  EXPECT_EQ(words(validate(not_a_number, 100, parts), ""), "cannot be judged: E = nan");
  EXPECT_EQ(validate(INFINITY, 100, parts).outcome, Outcome::unknown);
  EXPECT_EQ(validate(100, 100, {}).outcome, Outcome::unknown);
}

TEST(Validation, RefusesWhatIsNoUncertainty) {
  EXPECT_THROW(validate(1, 2, {.numerical = -1}), std::invalid_argument);
  EXPECT_THROW(validate(1, 2, parts, 0), std::invalid_argument);
  EXPECT_THROW(validate(1, 2, parts, 1, not_a_number), std::invalid_argument);
}

TEST(Validation, TakesPercentilesOfRepeatsAsThoseOfANormalDistribution) {
  EXPECT_NEAR(standard_of_95_percent(100 - 1.959964 * 3, 100 + 1.959964 * 3), 3, 1e-12);
}

}  // namespace validation_test
}  // namespace touchstone::vnv
