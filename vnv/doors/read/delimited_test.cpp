#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "vnv/doors/read/testing.hpp"

namespace touchstone::vnv::doors {
namespace delimited_test {

std::vector<Dataset> read(std::string_view text) { return read_as("delimited", "run.csv", text, {}); }
std::string refusal(std::string_view text, const Limits& limits = {}) {
  return doors::refusal([&] { read_as("delimited", "run.csv", text, limits); });
}

TEST(Delimited, IsReadWithAnySeparatorAndHeading) {
  for (const char* text :
       {"x,y [m]\n1,2\n3,4\n", "x;y [m]\r\n1;2\r\n3;4\r\n", "x\ty [m]\n1\t2\n3\t4", "# x y [m]\n1 2\n 3   4 \n",
        "% made by hand\n\n#x, y [m]\n#\n1, 2\n# between\n3, 4\n", "\"x\",\"y [m]\"\n1,2\n3,4\n"}) {
    const std::vector<Dataset> found = read(text);
    ASSERT_EQ(found.size(), 1u) << text;
    ASSERT_EQ(found[0].arrays.size(), 2u) << text;
    EXPECT_EQ(found[0].arrays[0].name, "x") << text;
    EXPECT_EQ(found[0].arrays[1].name, "y [m]") << text;
    EXPECT_EQ(found[0].arrays[0].values, (std::vector<double>{1, 3})) << text;
    EXPECT_EQ(found[0].arrays[1].values, (std::vector<double>{2, 4})) << text;
  }
}

TEST(Delimited, NumbersColumnsThatHaveNoNames) { EXPECT_EQ(read("1 2\n3 4\n")[0].arrays[1].name, "column 2"); }

TEST(Delimited, ReadsEachNumberExactlyAndWhatIsNone) {
  const std::vector<double> values = read("v\n0.1\n+1e-300\n-inf\nnan\n")[0].arrays[0].values;
  EXPECT_EQ(values[0], 0.1);
  EXPECT_EQ(values[1], 1e-300);
  EXPECT_EQ(values[2], -INFINITY);
  EXPECT_TRUE(std::isnan(values[3]));
}

TEST(Delimited, PartsRowsByTheirTime) {
  const std::vector<Dataset> found = read("Time [s],x\n0.2,1\n0.1,2\n0.2,3\n");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].time, 0.1);
  EXPECT_EQ(found[1].array("x")->values, (std::vector<double>{1, 3}));
}

TEST(Delimited, HasATimeThatACommentSaysAndTheNumberThatEndsItsName) {
  for (const char* text : {"# t = 20\nx y\n1 2\n", "x,y\n1,2\n", "# Time: 20 s\n# x y\n1 2\n"}) {
    const Dataset found = read_as("delimited", "PartFluid_0020.csv", text, {}).at(0);
    EXPECT_EQ(found.index, 20) << text;
    EXPECT_EQ(found.time, text[0] == '#' ? std::optional(20.0) : std::nullopt) << text;
    EXPECT_EQ(found.arrays.at(0).name, "x") << text;
  }
  EXPECT_EQ(read("# time = 20 apples\n# x y\n1 2\n").at(0).time, std::nullopt);
}

TEST(Delimited, HasTheUnitOfItsTimeFromAHeadingOrAComment) {
  for (const char* text : {"time [ms],x\n20,1\n", "t (ms);x\n20;1\n", "t (ms) x\n20 1\n", "Time [ms],x\n20,1\n30,2\n",
                           "# time = 20 ms\nx\n1\n", "# t [ms] = 20\nx\n1\n", "# t (ms): 20 ms\nx\n1\n"}) {
    const Dataset found = read(text).at(0);
    EXPECT_EQ(found.time, 20) << text;
    EXPECT_EQ(found.time_unit, "ms") << text;
  }
  EXPECT_EQ(read("t,x\n20,1\n").at(0).time_unit, "");
}

TEST(Delimited, IsRefusedInOneLine) {
  EXPECT_EQ(refusal("x,y\n1,2\n3,four\n"), "run.csv:3: column y: 'four', expected a number");
  EXPECT_EQ(refusal("x,y\n1,2\n3\n"), "run.csv:3: column y: '', expected a number");
  EXPECT_EQ(refusal("x,y\n1,2\n3,4,5\n"), "run.csv:3: more cells than columns, expected 2");
  EXPECT_EQ(refusal("x,y,z\n1,2\n"), "run.csv: 3 names of columns, 'x,y,z', expected 2 as in the first row");
  EXPECT_NE(refusal("").find("no row of numbers"), std::string::npos);
  EXPECT_NE(refusal(std::string_view("1\0 2\n", 5)).find("not text"), std::string::npos);
  EXPECT_EQ(refusal("x\n1\n\x1b[2J\n"), "run.csv:3: column x: '?[2J', expected a number") << "a terminal obeys it";
  std::string times = "t\n";
  for (int k = 0; k <= 100000; ++k) times += fmt::format("{}\n", k);
  EXPECT_EQ(refusal(times), "run.csv: '100001' times or more, expected no more than 100000");
  EXPECT_EQ(refusal("1\n2\n3\n", {.most_bytes = 16}), "run.csv:3: more than 16 bytes");
}

}  // namespace delimited_test
}  // namespace touchstone::vnv::doors
