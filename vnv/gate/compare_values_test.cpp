#include "vnv/gate/compare_values.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace touchstone::gate {
namespace {

Change smaller(double before, double after, std::optional<double> room = std::nullopt) {
  return compare_values(before, after, Direction::smaller, room).first;
}

TEST(CompareValues, WithoutABaselineAllowsTwoPerCent) {
  EXPECT_EQ(smaller(1, 1.0199), Change::same);
  EXPECT_EQ(smaller(1, 1.0201), Change::worse);
  EXPECT_EQ(smaller(1, 0.9799), Change::better);
}

TEST(CompareValues, TakesRoundingOfZeroForNoChange) {
  EXPECT_EQ(smaller(0, 9e-13, 0.0), Change::same);
  EXPECT_EQ(smaller(1e-16, 7e-13), Change::same);
  EXPECT_EQ(smaller(0, 1.1e-12, 0.0), Change::worse);
}

TEST(CompareValues, NeverPassesATenthWhateverABaselineAllows) {
  for (const double room : {0.0, 0.02, 0.05, 0.1, 0.2, 0.49}) EXPECT_GE(smaller(1, 1.1, room), Change::inconclusive);
  for (const double room : {0.0, 0.03, 0.05, 0.1})
    EXPECT_GE(compare_values(1, 0.95, Direction::larger, room).first, Change::inconclusive) << room;
}

TEST(CompareValues, JudgesNothingInsideARoomAsWideAsTheValue) {
  EXPECT_EQ(smaller(1, 1.4, 1.0), Change::unjudged);
  EXPECT_EQ(smaller(1, 1.04, 1.0), Change::same);
  EXPECT_EQ(smaller(1, 2.1, 1.0), Change::worse);
}

TEST(CompareValues, TakesInfinityForNoNumber) {
  EXPECT_EQ(smaller(1, INFINITY), Change::worse);
  EXPECT_EQ(smaller(INFINITY, vnv::not_a_number), Change::same);
  EXPECT_EQ(compare_values(1, INFINITY, Direction::larger, std::nullopt).first, Change::worse);
}

TEST(Meaning, IsToldByTheNamesOfBaselines) {
  EXPECT_EQ(meaning_of("roughness of p over rho g h0 [%]").kind, Kind::error);
  EXPECT_EQ(meaning_of("largest stable c dt / length, measured [-]").direction, Direction::larger);
  EXPECT_EQ(meaning_of("critical time step over (31) [-]").kind, Kind::stability);
  EXPECT_EQ(meaning_of("decay rate of energy, less the exact [%]").direction, Direction::towards_zero);
  EXPECT_EQ(meaning_of("growth per step beyond, measured [-]").direction, Direction::unknown);
  EXPECT_TRUE(meaning_of("time of the plain loop over that of the solver [-]").of_the_machine);
  EXPECT_FALSE(meaning_of("critical time step, stable end [us]").of_the_machine);
}

}  // namespace
}  // namespace touchstone::gate
