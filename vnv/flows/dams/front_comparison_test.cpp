#include "vnv/flows/dams/front_comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace touchstone::vnv {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Window early{0.3, 1.5}, late{1, 1.5}, shifts{-0.2, 0.2};

/// A made-up front that first gathers speed.
double made_up(double T) { return std::sqrt(1 + 2 * T * T); }

FrontHistory front(const std::function<double(double)>& L, double step, double from = 0, double to = 2) {
  FrontHistory history;
  for (int i = 0; from + i * step <= to + step / 2; ++i) {
    history.T.push_back(from + i * step);
    history.L.push_back(L(history.T.back()));
  }
  return history;
}

const auto computed = front(made_up, 0.002);
const auto measured = front(made_up, 0.05, 0, 1.6);

TEST(FrontComparison, OfTwoReadingsOfOneFrontFindsNothing) {
  const auto found = compare_fronts(computed, measured, early, late, shifts);
  EXPECT_LT(found.rms, 1e-5);
  EXPECT_NEAR(found.best_shift, 0, 1e-5);
  EXPECT_NEAR(found.slope, found.measured_slope, 0.01);
}

TEST(FrontComparison, FindsAConstantLeadAsTheRms) {
  const auto ahead = front([](double T) { return made_up(T) + 0.07; }, 0.002);
  const auto behind = front([](double T) { return made_up(T) - 0.07; }, 0.002);
  EXPECT_NEAR(compare_fronts(ahead, measured, early, late, shifts).rms, 0.07, 1e-5);
  EXPECT_NEAR(compare_fronts(behind, measured, early, late, shifts).rms, 0.07, 1e-5);
}

TEST(FrontComparison, FindsAClockThatIsOffWithItsSignAndPutsItRight) {
  for (const double too_early : {-0.137, -0.02, 0.051, 0.15}) {
    const auto ours = front([&](double T) { return made_up(T + too_early); }, 0.002);
    const auto found = compare_fronts(ours, measured, early, late, shifts);
    EXPECT_NEAR(found.best_shift, too_early, 1e-4);
    EXPECT_LT(found.rms_at_best_shift, 1e-4) << too_early;
    EXPECT_GT(found.rms, 0.5 * std::abs(too_early)) << "the rms is that of the clocks as they are";
  }
}

TEST(FrontComparison, NeverShiftsBeyondTheDeclaredRange) {
  const auto ours = front([](double T) { return made_up(T + 0.15); }, 0.002);
  const auto found = compare_fronts(ours, measured, early, late, {-0.1, 0.1});
  EXPECT_EQ(found.best_shift, 0.1);
  EXPECT_LT(found.rms_at_best_shift, found.rms);
  EXPECT_GT(found.rms_at_best_shift, 0.02);
}

TEST(FrontComparison, WithARangeOfOneShiftTakesIt) {
  const auto found = compare_fronts(computed, measured, early, late, {0, 0});
  EXPECT_EQ(found.best_shift, 0);
  EXPECT_EQ(found.rms_at_best_shift, found.rms);
}

TEST(FrontComparison, IsNotWorseAtTheBestShiftThanAtAnyOther) {
  const auto rough = front([](double T) { return made_up(1.1 * T) + 0.02 * std::sin(40 * T); }, 0.01);
  const auto best = compare_fronts(rough, measured, early, late, shifts);
  for (double s = shifts.low; s <= shifts.high; s += 0.01)
    EXPECT_GE(compare_fronts(rough, measured, early, late, {s, s}).rms_at_best_shift, best.rms_at_best_shift - 1e-9)
        << s;
}

TEST(FrontComparison, HasSlopesThatNoShiftOfAStraightFrontChanges) {
  const auto line = [](double T) { return 0.6 + 1.34 * T; };
  const auto found =
      compare_fronts(front([&](double T) { return line(T + 0.3); }, 0.002), front(line, 0.03), early, late, shifts);
  EXPECT_NEAR(found.slope, 1.34, 1e-12);
  EXPECT_NEAR(found.measured_slope, 1.34, 1e-12);
}

TEST(FrontComparison, TellsTheSlopesOfTheTwoApart) {
  const auto fast = front([](double T) { return 1 + 1.5 * T; }, 0.002);
  const auto slow = front([](double T) { return 1 + 1.2 * T; }, 0.05);
  const auto found = compare_fronts(fast, slow, early, late, shifts);
  EXPECT_NEAR(found.slope, 1.5, 1e-12);
  EXPECT_NEAR(found.measured_slope, 1.2, 1e-12);
}

TEST(FrontComparison, ReadsOnlyWhatIsInItsWindows) {
  auto odd = measured;
  odd.L.front() = 100;
  odd.L.back() = nan;
  const auto found = compare_fronts(computed, odd, early, late, shifts);
  EXPECT_LT(found.rms, 1e-5);
  EXPECT_NEAR(found.best_shift, 0, 1e-5);
  EXPECT_TRUE(std::isfinite(found.measured_slope));
}

TEST(FrontComparison, KeepsWhatIsNotANumber) {
  auto lost = computed;
  lost.L[500] = nan;  // T = 1
  for (const auto& found : {compare_fronts(lost, measured, early, late, shifts),
                            compare_fronts(computed, front([](double) { return nan; }, 0.05), early, late, shifts)}) {
    EXPECT_TRUE(std::isnan(found.rms));
    EXPECT_TRUE(std::isnan(found.best_shift));
    EXPECT_TRUE(std::isnan(found.rms_at_best_shift));
    EXPECT_TRUE(std::isnan(found.slope) || std::isnan(found.measured_slope));
  }
}

TEST(FrontComparison, KeepsALossThatOnlyAShiftWouldUse) {
  auto lost = computed;
  lost.L[60] = nan;  // T = 0.12: before every measured point, within reach of a shift
  const auto found = compare_fronts(lost, measured, early, late, shifts);
  EXPECT_TRUE(std::isfinite(found.rms));
  EXPECT_TRUE(std::isnan(found.best_shift));
  EXPECT_TRUE(std::isnan(found.rms_at_best_shift));
}

template <class Exception>
std::string refusal(const FrontHistory& ours, const FrontHistory& theirs, Window rms = early, Window slope = late,
                    Window shift = shifts) {
  try {
    compare_fronts(ours, theirs, rms, slope, shift);
  } catch (const Exception& refused) {
    return refused.what();
  }
  return "";
}

TEST(FrontComparison, RefusesAWindowWithoutData) {
  const auto short_run = front(made_up, 0.002, 0, 1.4), short_film = front(made_up, 0.05, 0, 1.4);
  const auto sparse = front(made_up, 1.7, 0, 2);
  EXPECT_NE(refusal<std::domain_error>(short_run, measured).find("our front covers T = 0 to 1.4"), std::string::npos);
  EXPECT_NE(refusal<std::domain_error>(computed, short_film).find("the measured front covers"), std::string::npos);
  EXPECT_NE(refusal<std::domain_error>(computed, sparse).find("0 points"), std::string::npos);
  EXPECT_NE(refusal<std::domain_error>(computed, measured, {0.1, 1.5}).find("all its shifts"), std::string::npos);
  EXPECT_NE(refusal<std::domain_error>(computed, measured, early, {1.01, 1.06}).find("for the slope"),
            std::string::npos);
}

TEST(FrontComparison, RefusesASeriesThatIsNone) {
  const std::vector<FrontHistory> bad{{{0, 1, 1, 2}, {1, 2, 3, 4}},
                                      {{0, 2, 1}, {1, 2, 3}},
                                      {{0, nan, 2}, {1, 2, 3}},
                                      {{0, 1, 2}, {1, 2}},
                                      {{0}, {1}},
                                      {{}, {}},
                                      {{nan, 1}, {1, 2}},
                                      {{0, 1, INFINITY}, {1, 2, 3}}};
  for (const auto& series : bad) {
    EXPECT_NE(refusal<std::invalid_argument>(series, measured).find("our front has"), std::string::npos);
    EXPECT_NE(refusal<std::invalid_argument>(computed, series).find("the measured front has"), std::string::npos);
  }
}

TEST(FrontComparison, RefusesAWindowThatIsNone) {
  for (const Window& bad : {Window{1.5, 1.0}, Window{nan, 1.5}, Window{1.0, nan}}) {
    EXPECT_NE(refusal<std::invalid_argument>(computed, measured, bad).find("rms window"), std::string::npos);
    EXPECT_NE(refusal<std::invalid_argument>(computed, measured, early, bad).find("slope window"), std::string::npos);
    EXPECT_NE(refusal<std::invalid_argument>(computed, measured, early, late, bad).find("shifts"), std::string::npos);
  }
}

}  // namespace
}  // namespace touchstone::vnv
