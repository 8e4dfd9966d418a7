#include <gtest/gtest.h>

#include "vnv/doors/read/refusals_testing.hpp"

namespace touchstone::vnv::doors {
namespace measuretool_test {

TEST(MeasureTool, GivesItsPlacesAtEachTime) {
  const std::vector<Dataset> times = read_datasets(samples() / "measuretool" / "line_Vel.csv");
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(times[0].time, 0.5);
  EXPECT_EQ(times[1].time, 1);
  EXPECT_EQ(times[1].array(points_array)->values, (std::vector{0.25, 0.0, 0.1, 0.25, 0.0, 0.3, 0.25, 0.0, 0.5}));
  EXPECT_EQ(times[1].array("Vel [m/s]")->values, (std::vector{1.25, 0.0, 0.0, 2.25, 0.0, 0.0, -3.25, 0.0, 0.0}));
  EXPECT_EQ(times[1].rows_are, Rows::probes);
}

TEST(MeasureTool, IsRefusedInALineWhereItIsNone) {
  const std::string places = " ;PosX [m]:;0;1\n ;PosY [m]:;0;0\n ;PosZ [m]:;0;1\n",
                    heads = "Part;Time [s];Press_0 [Pa];Press_1 [Pa]\n";
  EXPECT_EQ(read_as("measuretool", "a.csv", places + heads + "0;0.5;7;8\n", {}).at(0).array("Press [Pa]")->values,
            (std::vector<double>{7, 8}));
  expect_refusals("measuretool", "a.csv",
                  {{places + heads + "0;0.5;7\n", "a.csv:5: 3 cells, expected 4 as headings"},
                   {places + heads + "0;0.5;7;up\n", "Press [Pa]: 'up', expected a number"},
                   {places + "Part;Time [s];Press_2 [Pa]\n0;0;0\n", "'Press_2 [Pa]', of which there is no place"},
                   {places + "Part;Press_0 [Pa]\n0;0\n", "no time or no field of a place"},
                   {std::string(" ;PosX [m]:;0;1\n ;PosY [m]:;0\n"), "1 places, expected 2 as along x"},
                   {std::string(" ;PosX [m]:;0\n ;PosY [m]:;0;0\n"), "more places than along x"},
                   {std::string(" ;PosX [m]:;0\n"), "ends, expected three lines of places"}});
}

}  // namespace measuretool_test
}  // namespace touchstone::vnv::doors
