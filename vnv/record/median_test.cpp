#include "vnv/record/median.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::vnv {
namespace {

TEST(Median, IsTheMiddleOneOrTheMeanOfTwo) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_TRUE(std::isnan(median({})));
}

}  // namespace
}  // namespace touchstone::vnv
