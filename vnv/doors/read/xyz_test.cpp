#include <gtest/gtest.h>

#include "vnv/doors/read/refusals_testing.hpp"

namespace touchstone::vnv::doors {
namespace xyz_test {

TEST(Xyz, GivesEachFrameOfTheExtendedLayout) {
  const std::vector<Dataset> frames = read_datasets(samples() / "xyz" / "extended.xyz");
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].time, 0.5);
  EXPECT_EQ(frames[1].time, 1);
  EXPECT_EQ(frames[0].array("species")->labels, (std::vector<std::string>{"fluid", "wall"}));
  EXPECT_EQ(frames[0].array("pos")->values, (std::vector{0.1, 0.2, 0.0, 0.3, 0.0, 0.0}));
  EXPECT_EQ(frames[1].array("velocity")->values, (std::vector{1.25, -0.25, 0.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(frames[0].array("moves")->values, (std::vector<double>{1, 0}));
  EXPECT_EQ(frames[0].format, "extended XYZ");
}

TEST(Xyz, OfThePlainLayoutHasPlacesAndColumns) {
  const std::vector<Dataset> frames = read_datasets(samples() / "xyz" / "plain_12.xyz");
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].array("y")->values, (std::vector{0.2, 0.4}));
  EXPECT_EQ(frames[0].array("column 5")->values, (std::vector{1.5, 2.5}));
  EXPECT_EQ(frames[0].index, 12) << "of its name";
}

TEST(Xyz, IsRefusedInALineWhereItIsNone) {
  expect_refusals("xyz", "a.xyz",
                  {{"two\n\n", "a.xyz:1: 'two', expected how many rows there are"},
                   {"2\n\nAr 1 2 3\n", "ends within"},
                   {"1\n\nAr 1 2\n", "expected a species and three coordinates"},
                   {"1\n\nAr 1 2 z\n", "number 1 'z', expected a number"},
                   {"2\n\nAr 1 2 3\nAr 1 2 3 4\n", "a.xyz:4: more cells than columns, expected 4"},
                   {"1\nProperties=pos:R\n1 2 3\n", "Properties of 'pos', expected NAME:S, R, I or L:COUNT each"},
                   {"1\nProperties=pos:R:0\n1 2 3\n", "pos of 0 columns"},
                   {"99999999999\n\nAr 1 2 3\n", "99999999999"},
                   {"1\nTime=inf Properties=pos:R:1\n1\n", "Time: 'inf', expected a time"}});
}

}  // namespace xyz_test
}  // namespace touchstone::vnv::doors
