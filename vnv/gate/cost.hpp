#pragma once
/// Which methods became slower or faster, with few false alarms over all of them.

#include "vnv/gate/difference.hpp"
#include "vnv/gate/paired_times.hpp"

#include <functional>
#include <string>
#include <vector>

namespace touchstone::gate {

/// What one method took in runs in turn: user CPU time, or that of another resource which it says it occupies.
struct Timing {
  std::string case_name, method;
  std::vector<double> before, after;                                                        // s  pair by pair
  vnv::Resource resource_before = vnv::Resource::cpu, resource_after = vnv::Resource::cpu;  // unequal: not compared
};

/// A change below this fraction matters to nobody.
inline constexpr double smallest_slowdown = 0.02;
/// A slow-down of this fraction must not be missed: while the interval reaches it, nothing is the same.
inline constexpr double noticed_slowdown = 0.05;
/// How often all rows of a gate together may raise a false alarm: once in a thousand gates, a tenth in a hundred.
inline constexpr double false_alarms = 0.001;
/// Runs shorter than this [s] are not timed: clocks of user time count in ticks on some machines.
inline constexpr double shortest_timed = 0.05;
/// A method in doubt is timed anew with this many times the pairs: 30 of 6, enough to rule chance out though some are
/// disturbed.
inline constexpr long times_the_pairs = 5;

/// Whether the first timing leaves no doubt: long enough a run, within `smallest_slowdown` of equal, and sure to be
/// less than `noticed_slowdown` off. What is not settled is timed anew, and judged by its new runs alone: the old ones
/// selected it.
bool is_settled(const Timing& timing);

/// Judges all rows timed together, by Holm's rule (Holm, Scand. J. Statist. 6 (1979), 65-70): worse or better
/// where chance is ruled out and the estimate is off by `smallest_slowdown` or more. Else the same if the estimate is
/// less off and the interval ends below `noticed_slowdown`, and inconclusive if not. Too short runs and times of two
/// resources are unjudged. Times are reported as medians.
std::vector<Difference> judge_costs(const std::vector<Timing>& timings);

/// Times some methods anew, with more pairs.
using TimeAgain = std::function<std::vector<Timing>(const std::vector<Timing>& doubtful)>;

/// Compares all methods, those that the first timing does not settle by a second one.
std::vector<Difference> compare_costs(const std::vector<Timing>& first, const TimeAgain& time_again);

}  // namespace touchstone::gate
