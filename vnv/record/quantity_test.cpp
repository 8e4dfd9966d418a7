#include "vnv/record/quantity.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv {
namespace {

TEST(Quantities, EndWithTheirUnit) {
  EXPECT_EQ(name_and_unit("L2 v_x, row means [%]"), std::pair(std::string("L2 v_x, row means"), std::string("%")));
  EXPECT_EQ(name_and_unit("growth [-]"), std::pair(std::string("growth"), std::string()));
  EXPECT_EQ(name_and_unit("order"), std::pair(std::string("order"), std::string()));
}

}  // namespace
}  // namespace touchstone::vnv
