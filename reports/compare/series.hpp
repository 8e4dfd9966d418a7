#pragma once
/// Each number of the nights as a series over them, and the steps in it.

#include "reports/read/night.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::reports {

/// Where a series leaves its level: from one night on it has another value.
struct Step {
  std::size_t night;     // the first with the new value
  double before, after;  // the level it leaves, its first new value
};

/// One night of a series.
struct SeriesPoint {
  bool is_there = false;
  double value = vnv::not_a_number;
  bool fails = false;     // a claim on it fails
  std::string machine{};  // that ran its method

  bool is_finite() const { return is_there && std::isfinite(value); }
};

struct Series {
  enum class Kind { error, limit, order, cost };
  Kind kind = Kind::error;
  std::string case_name, method, level;    // no level: of a whole ladder
  double spacing = vnv::not_a_number;      // m
  double time = vnv::not_a_number;         // s
  std::string quantity;                    // with its unit
  std::string author{};                    // of the last claim by theory or literature; empty if there is none
  std::optional<double> lower{}, upper{};  // of that claim
  bool has_margin = false;                 // its claim is not one of counting
  std::optional<double> tolerance{};       // half the width of the last baseline
  long levels = 0;                         // of an order
  std::vector<SeriesPoint> points{};       // one per night
  std::vector<Step> steps{};

  /// Lowest and highest finite value; without one the lowest is above the highest.
  std::pair<double, double> range() const;
};

/// The last night before a step that has a value, if another kind of machine ran it; where its revision is the same,
/// the value depends on the machine.
std::optional<std::size_t> night_on_another_machine(const Series& series, const Step& step);

/// Every series of these nights, by case and method. Its steps are marked by one rule:
///
/// A level is the median of the first fifteen nights since the last step, so that a slow drift leaves it too. The next
/// night is a step if it is further from the level than the tolerance and than four times the spread, if a claim on it
/// fails that held or holds that failed, or if it becomes or ceases to be a number. The tolerance is half the width of
/// the baseline; without one a hundredth of the level, for a cost a tenth. The spread is the standard deviation by the
/// median difference of neighbouring nights, known from five nights on: nothing where reruns are equal to the bit, and
/// the machine's noise where they are not. A cost is a step only if the night after stands as far to the same side, so
/// that one loud night is none; and where its machine, compiler or flags change it starts anew.
std::vector<Series> series_of(const std::vector<Night>& nights);

/// Marks the steps of a series. `starts_anew` says of each night whether compiler or flags are others than the night
/// before.
void mark_steps(Series& series, const std::vector<bool>& starts_anew);

/// The few that are drawn of each method: what theory or literature judge, at the last time and the finest spacing of
/// each quantity; orders of the L2 norms; stability limits; time and memory of the most expensive run.
std::vector<const Series*> worth_drawing(const std::vector<Series>& all);

}  // namespace touchstone::reports
