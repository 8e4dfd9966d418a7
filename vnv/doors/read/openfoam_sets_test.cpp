#include <gtest/gtest.h>

#include "vnv/doors/read/refusals_testing.hpp"

namespace touchstone::vnv::doors {
namespace openfoam_sets_test {

TEST(OpenFoamSets, AreOfTheFieldsThatTheirNamesSay) {
  const Dataset by_distance = read_datasets(samples() / "openfoam_sets" / "line_U.xy").at(0),
                by_places = read_datasets(samples() / "openfoam_sets" / "line_p_U.xy").at(0);
  EXPECT_EQ(by_distance.array("distance")->values, (std::vector{0.1, 0.3, 0.5}));
  EXPECT_EQ(by_distance.array("U")->values, (std::vector{1.5, -0.5, 0.0, 2.5, 0.25, 0.0, -3.5, 0.125, 0.0}));
  EXPECT_EQ(by_places.array("p")->values, (std::vector{3.5, 2.5, 1.5}));
  EXPECT_EQ(by_places.array(points_array)->at(1, 1), 0.3);
  EXPECT_EQ(by_places.array("U")->values, by_distance.array("U")->values);
  for (const Dataset& one : {by_distance, by_places}) EXPECT_EQ(one.rows_are, Rows::probes);
}

TEST(OpenFoamSets, AreOfTheTimeOfTheirFolder) {
  EXPECT_EQ(read_as("openfoam_sets", "sets/0.5/line_T.xy", "0 1\n1 2\n", {}).at(0).time, 0.5);
  EXPECT_FALSE(read_as("openfoam_sets", "sets/line_T.xy", "0 1\n1 2\n", {}).at(0).time);
}

TEST(OpenFoamSets, AreRefusedInALineWhereTheyAreNone) {
  expect_refusals("openfoam_sets", "line_U.xy",
                  {{"1 2\n", "2 columns, expected a coordinate or three"},
                   {"1 2 3 4\n1 2 3\n", "line_U.xy:2: U: number 3 '', expected a number"},
                   {"1 2 3 4\n1 2 3 4 5\n", "line_U.xy:2: more numbers than 4 columns"},
                   {"", "0 columns"}});
}

}  // namespace openfoam_sets_test
}  // namespace touchstone::vnv::doors
