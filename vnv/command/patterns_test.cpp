#include "vnv/command/patterns.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace touchstone::vnv::command {
namespace {

using Names = std::vector<std::string>;
const Names names{"oscillating_poiseuille.mpm", "poiseuille.mpm", "poiseuille.mpm_affine", "couette.sph"};

TEST(APattern, ThatNamesAMethodChoosesItAlone) { EXPECT_EQ(matches("poiseuille.mpm", names), Names{"poiseuille.mpm"}); }

TEST(APattern, ThatNamesACaseChoosesItsMethodsAlone) {
  EXPECT_EQ(matches("poiseuille", names), (Names{"poiseuille.mpm", "poiseuille.mpm_affine"}));
}

TEST(APattern, WithStarsIsAGlobOfTheWholeNameOrOfTheCase) {
  EXPECT_EQ(matches("*.mpm", names), (Names{"oscillating_poiseuille.mpm", "poiseuille.mpm"}));
  EXPECT_EQ(matches("c*e", names), Names{"couette.sph"});
  EXPECT_EQ(matches("pois*", names), (Names{"poiseuille.mpm", "poiseuille.mpm_affine"}));
}

TEST(APattern, ThatIsNoNameIsAPartOfSome) {
  EXPECT_EQ(matches("affine", names), Names{"poiseuille.mpm_affine"});
  EXPECT_EQ(matches("oiseuille.m", names).size(), 3u);
}

TEST(Patterns, ChooseEachNameOnceAndInOrder) {
  EXPECT_EQ(chosen_by({"couette", "poiseuille.mpm", "*.sph"}, names), (Names{"poiseuille.mpm", "couette.sph"}));
  EXPECT_EQ(chosen_by({}, names), names);
}

TEST(Patterns, ThatChooseNothingAreRefused) {
  EXPECT_THROW(chosen_by({"couette", "dam"}, names), std::invalid_argument);
}

TEST(APattern, TellsAmongWhichCasesToLook) {
  const Names cases{"couette", "oscillating_poiseuille", "poiseuille"};
  EXPECT_EQ(possible_cases("poiseuille", cases), Names{"poiseuille"});
  EXPECT_EQ(possible_cases("poiseuille.mpm*", cases), Names{"poiseuille"});
  EXPECT_EQ(possible_cases("pois", cases), (Names{"oscillating_poiseuille", "poiseuille"}));
  EXPECT_EQ(possible_cases("c*", cases), Names{"couette"});
  EXPECT_EQ(possible_cases("*.mpm", cases), cases);
  EXPECT_EQ(possible_cases("seuille.m", cases), cases);
  EXPECT_EQ(possible_cases("affine", cases), cases);
}

}  // namespace
}  // namespace touchstone::vnv::command
