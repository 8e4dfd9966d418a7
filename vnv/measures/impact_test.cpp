#include "vnv/measures/impact.hpp"

#include "vnv/files/data_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace touchstone::vnv {
namespace impact_test {

/// Nothing until 1 s, up to 100 Pa at 1.1 s, down to 20 Pa at 1.5 s, 20 Pa until 3 s, and a larger one at 4 s.
const Series made_up{{0, 1, 1.1, 1.5, 3, 4, 5}, {0, 0, 100, 20, 20, 300, 0}};
const ImpactSearch search{.threshold = 30,
                          .peak_within = 1,
                          .plateau_from = 0.5,
                          .plateau_to = 1.5,
                          .arrival_fraction = 0.2,
                          .impulse_over = 0.28};

TEST(AnImpact, IsToldByItsFirstPeak) {
  const Impact found = impact_of(made_up, search);
  EXPECT_EQ(found.peak, 100);
  EXPECT_EQ(found.peak_time, 1.1);
  EXPECT_NEAR(found.arrival, 1.02, 1e-12) << "at 20 Pa";
  EXPECT_NEAR(found.rise, 0.05, 1e-12);
  EXPECT_NEAR(found.decay, 0.25, 1e-12);
  EXPECT_NEAR(found.peak_impulse, 75 * 0.05 + 75 * 0.25, 1e-12);
  // From 1.02 to 1.3 s: up from 20 to 100 Pa in 0.08 s, down to 60 Pa in 0.2 s.
  EXPECT_NEAR(found.impulse, 60 * 0.08 + 80 * 0.2, 1e-12);
  EXPECT_NEAR(found.plateau, 20, 1e-12) << "from 1.52 to 2.52 s";
}

TEST(AnImpact, HasForItsPlateauTheMeanOverTimeOfAWindowThatBeginsAtItsArrival) {
  // Falls from 100 Pa at 1.1 s by 20 Pa in a second, sampled unevenly; at 20 Pa, on the way up, it arrives at 1.02 s.
  const Series falls{{0, 1, 1.1, 1.6, 1.7, 3, 4}, {0, 0, 100, 90, 88, 62, 42}};
  ImpactSearch search_of_it = search;
  EXPECT_NEAR(impact_of(falls, search_of_it).plateau, 100 - 20 * (1.52 + 0.5 - 1.1), 1e-12);
  search_of_it.plateau_from = 1, search_of_it.plateau_to = 1.2;
  EXPECT_NEAR(impact_of(falls, search_of_it).plateau, 100 - 20 * (1.02 + 1.1 - 1.1), 1e-12);
}

TEST(AnImpact, TakesALaterPeakOnlyIfItIsLookedForThatLong) {
  ImpactSearch longer = search;
  longer.peak_within = 4;
  EXPECT_EQ(impact_of(made_up, longer).peak, 300);
  longer.peak_within = 3;
  EXPECT_TRUE(std::isnan(impact_of(made_up, longer).peak)) << "it still rises then";
}

TEST(AnImpact, LosesWhatTheSeriesDoesNotReach) {
  const Impact cut = impact_of({{0, 1, 1.1, 1.2}, {0, 0, 100, 80}}, search);
  EXPECT_EQ(cut.peak, 100);
  EXPECT_NEAR(cut.rise, 0.05, 1e-12);
  EXPECT_TRUE(std::isnan(cut.decay) && std::isnan(cut.peak_impulse) && std::isnan(cut.impulse) &&
              std::isnan(cut.plateau));
  const Impact begun_before = impact_of({{0, 0.5, 1}, {90, 100, 0}}, search);
  EXPECT_EQ(begun_before.arrival, 0);
  EXPECT_TRUE(std::isnan(begun_before.rise));
}

TEST(AnImpact, IsNoneBelowTheThresholdOrForNoNumber) {
  EXPECT_TRUE(std::isnan(impact_of({{0, 1, 2}, {0, 30, 0}}, search).peak));
  EXPECT_TRUE(std::isnan(impact_of({{0, 1, 2, 3}, {0, 90, 0, not_a_number}}, search).arrival));
}

TEST(AnImpact, IsThatOfTheExperimentByItsOwnNumbers) {
  const DataTable event = read_table(data_folder() / "experiments/lobovsky_2014_pressure_event_300.csv");
  const Impact found = impact_of(series_of(event, "T_H [-]", "P1 [-]"),
                                 {.threshold = 0.5, .peak_within = 0.3, .plateau_from = 1, .plateau_to = 2});
  EXPECT_NEAR(found.peak, 3.044, 5e-4);
  EXPECT_NEAR(found.peak_time, 2.4546, 1e-4);
  EXPECT_NEAR(found.arrival, 2.444, 0.002);
}

TEST(AnImpact, IsNotLookedForWithoutLengths) {
  ImpactSearch none = search;
  none.plateau_to = 0.5;
  EXPECT_THROW(impact_of(made_up, none), std::invalid_argument);
  EXPECT_THROW(impact_of({{0}, {1}}, search), std::invalid_argument);
}

}  // namespace impact_test
}  // namespace touchstone::vnv
