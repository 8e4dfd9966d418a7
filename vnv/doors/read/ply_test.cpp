#include <gtest/gtest.h>

#include "vnv/doors/read/refusals_testing.hpp"

namespace touchstone::vnv::doors {
namespace ply_test {

TEST(Ply, IsTheSameAsTextAndAsBytesOfEitherOrder) {
  for (const char* name : {"ascii.ply", "little_7.ply", "big_7.ply"}) {
    const std::vector<Dataset> all = read_datasets(samples() / "ply" / name);
    ASSERT_EQ(all.size(), 1u) << name;
    EXPECT_EQ(all[0].rows(), 3u);
    EXPECT_EQ(all[0].array("vx")->values, (std::vector{1.5, 2.5, -3.5})) << name;
    EXPECT_EQ(all[0].array("id")->values, (std::vector<double>{7, 8, 9})) << name;
    EXPECT_FLOAT_EQ(static_cast<float>(all[0].array("x")->values[1]), 0.3f) << name;
    if (all[0].time)
      EXPECT_EQ(all[0].time, 0.25);
    else
      EXPECT_EQ(all[0].index, 7) << "of its name";
  }
}

TEST(Ply, IsRefusedInALineWhereItIsNone) {
  const std::string vertices = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n";
  expect_refusals(
      "ply", "a.ply",
      {{vertices + "end_header\n1\n", "ends after 1 vertices, expected 2"},
       {vertices + "end_header\n1\nup\n", "vertex 2: x: number 1 'up', expected a number"},
       {vertices + "end_header\n1 2\n3\n", "vertex 1: more numbers than 1 properties"},
       {vertices, "ends within its header, expected 'end_header'"},
       {vertices + "property list uchar int i\nend_header\n1\n", "expected a property of one number of a vertex"},
       {"ply\nformat ascii 1.0\nelement face 2\n", "expected 'element vertex' before all others"},
       {"ply\nformat text 1.0\nelement vertex 0\nproperty float x\nend_header\n", "format 'text', expected ascii"},
       {"ply\nelement vertex 99999999999\nproperty float x\nend_header\n", "99999999999"},
       {"ply\nshape\n", "'shape', expected format, comment"}});
}

}  // namespace ply_test
}  // namespace touchstone::vnv::doors
