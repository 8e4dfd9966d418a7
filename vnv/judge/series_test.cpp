#include "vnv/judge/series.hpp"

#include "vnv/record/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace touchstone::vnv {
namespace series_test {

const Series roof{{0, 1, 3}, {0, 2, 0}};

Series constant(double value) { return {{-10, 10}, {value, value}}; }

TEST(ASeries, IsLinearBetweenItsSamplesAndNothingBeyond) {
  EXPECT_EQ(value_at(roof, 0), 0);
  EXPECT_EQ(value_at(roof, 0.25), 0.5);
  EXPECT_EQ(value_at(roof, 1), 2);
  EXPECT_EQ(value_at(roof, 2), 1);
  EXPECT_EQ(value_at(roof, 3), 0);
  EXPECT_TRUE(std::isnan(value_at(roof, 3.01)));
  EXPECT_TRUE(std::isnan(value_at(roof, -0.01)));
  EXPECT_EQ(value_at(shifted(roof, 0.5), 1.5), 2);
}

TEST(ASeries, IsIntegratedByTrapeziaAlsoBetweenItsSamples) {
  EXPECT_DOUBLE_EQ(time_integral(roof, 0, 3), 3);
  EXPECT_DOUBLE_EQ(time_integral(roof, 0.5, 2), 0.75 + 1.5);
  EXPECT_DOUBLE_EQ(time_mean(roof, 0.5, 2), 1.5);
  EXPECT_TRUE(std::isnan(time_integral(roof, 2, 3.5)));
  EXPECT_TRUE(std::isnan(time_mean({{0, 1, 2}, {1, not_a_number, 1}}, 0, 2)));
  EXPECT_THROW(time_integral(roof, 2, 2), std::invalid_argument);
}

TEST(ASeries, IsInsideABandForAFractionOfTheTime) {
  // The roof is above 1 from 0.5 to 2, and above 1.5 from 0.75 to 1.5.
  EXPECT_DOUBLE_EQ(fraction_inside(roof, constant(1), constant(3), 0, 3), 0.5);
  EXPECT_DOUBLE_EQ(fraction_inside(roof, constant(1), constant(1.5), 0, 3), 0.25);
  EXPECT_DOUBLE_EQ(fraction_inside(roof, constant(-1), constant(1), 0, 3), 0.5);
  EXPECT_DOUBLE_EQ(fraction_inside(roof, roof, roof, 0, 3), 1) << "edges are inside";
  EXPECT_DOUBLE_EQ(fraction_inside(roof, constant(1), constant(3), 0.5, 1.5), 1);
  // The band itself rises: 3 - t is above t up to 1.5.
  EXPECT_DOUBLE_EQ(fraction_inside(roof, {{0, 3}, {0, 3}}, constant(9), 0, 3), 0.5);
}

TEST(ASeries, IsOutsideWhereItIsNoNumberOrDoesNotReach) {
  const Series holed{{0, 1, 2, 3, 4}, {0, 0, not_a_number, 0, 0}};
  EXPECT_DOUBLE_EQ(fraction_inside(holed, constant(-1), constant(1), 0, 4), 0.5);
  EXPECT_DOUBLE_EQ(fraction_inside(roof, constant(-1), constant(9), 0, 6), 0.5);
}

TEST(ASeries, HasQuantilesOverSeveralMembers) {
  const Series median = quantile_of({constant(1), constant(7), roof}, {0, 1, 3}, 0.5);
  EXPECT_EQ(median.value, (std::vector<double>{1, 2, 1}));
  EXPECT_TRUE(std::isnan(quantile_of({constant(1), constant(2), roof}, {5}, 0).value[0]));
  EXPECT_THROW(quantile_of({}, {0}, 0.5), std::invalid_argument);
}

TEST(ASeries, ThatGoesBackInTimeIsRefusedByWhat) {
  const auto refusal = [](const Series& series) -> std::string {
    try {
      require_series("p", series);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(refusal({{0, 2, 1}, {1, 1, 1}}), "p: time 1 after 2, expected strictly increasing finite times");
  EXPECT_EQ(refusal({{0, 1}, {1}}), "p: 2 times and 1 values, expected two or more of each");
  EXPECT_EQ(refusal(roof), "none");
}

TEST(ASeries, OfATableIsInTheOrderOfTimeWithTheMeanOfEqualOnes) {
  const Sheet sheet = parse_sheet("t.csv",
                                  "# title: t\n# citation: c\n# source: s\n# scaling: none\n# geometry: none\n"
                                  "# uncertainty: none\nt [s],p [Pa]\n2,5\n1,1\n1,2\n1,6\n");
  const Series series = series_of(DataTable(sheet), "t [s]", "p [Pa]");
  EXPECT_EQ(series.time, (std::vector<double>{1, 2}));
  EXPECT_EQ(series.value, (std::vector<double>{3, 5}));
}

TEST(ASeries, IsScaledAfterItsOffset) {
  const Series found = scaled({{0, 2, 4}, {1, 2, 5}}, 2, 1, 4);
  EXPECT_EQ(found.time, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(found.value, (std::vector<double>{0, 0.25, 1}));
}

TEST(ASeries, DiffersFromAMeasuredOneAtItsTimesWithinARange) {
  const Series ours{{0, 2}, {0, 4}}, measured{{0, 0.5, 1, 2}, {5, 0, 3, 1}};
  EXPECT_EQ(differences(ours, measured, 0.5, 1), (std::vector<double>{1, -1}));
  EXPECT_EQ(root_mean_square({3, -4}), std::sqrt(12.5));
  EXPECT_TRUE(std::isnan(root_mean_square({})));
}

}  // namespace series_test
}  // namespace touchstone::vnv
