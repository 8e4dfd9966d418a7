#include "vnv/record/quantity.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv {
namespace {

TEST(Quantity, IsReadFromItsHeadingAndWrittenBack) {
  for (const std::string heading : {"L2 v_x, row means [%]", "growth [-]", "peak memory [GB]"})
    EXPECT_EQ(with_heading(heading).heading(), heading);
  EXPECT_EQ(with_heading("L2 v_x, row means [%]").unit, "%");
  EXPECT_EQ(with_heading("growth [-]").unit, "");
  EXPECT_EQ(with_heading("order").name, "order");
}

TEST(Quantity, GetsBetterAsItsKindDoesUnlessItSaysOtherwise) {
  EXPECT_EQ((Quantity{"L2 v_x", "%", Kind::norm}.better), Better::smaller);
  EXPECT_EQ((Quantity{"period off", "%", Kind::deviation}.better), Better::nearer_zero);
  EXPECT_EQ((Quantity{"longest step", "us", Kind::stability_limit}.better), Better::larger);
  EXPECT_EQ((Quantity{"steps completed", "", Kind::count}.better), Better::undeclared);
  EXPECT_EQ((Quantity{"speed-up", "", Kind::cost, Better::larger}.better), Better::larger);
}

}  // namespace
}  // namespace touchstone::vnv
