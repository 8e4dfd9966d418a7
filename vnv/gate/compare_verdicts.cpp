#include "vnv/gate/compare_verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::gate {
namespace {

using vnv::Better, vnv::Outcome, vnv::Verdict;

std::string_view predicate_of(Outcome outcome) {
  return outcome == Outcome::holds ? "holds" : outcome == Outcome::fails ? "fails" : "is inconclusive";
}

int rank_of(Outcome outcome) { return outcome == Outcome::holds ? 2 : outcome == Outcome::inconclusive ? 1 : 0; }

/// Whether a baseline is left on the side on which its value is better.
bool is_left_for_the_better(const Verdict& before, const Verdict& after) {
  if (!after.author.starts_with("baseline") || !after.lower || !after.upper) return false;
  if (after.better == Better::smaller) return after.value < *after.lower;
  if (after.better == Better::larger) return after.value > *after.upper;
  return after.better == Better::nearer_zero && std::abs(after.value) < std::abs(before.value);
}

/// Whether a baseline, which follows its value to either side, has got wider than the value has got larger.
bool allows_more(const Verdict& before, const Verdict& after) {
  const double width = *before.upper - *before.lower, centre = (*before.upper + *before.lower) / 2;
  const double new_width = *after.upper - *after.lower, new_centre = (*after.upper + *after.lower) / 2;
  const bool is_relative = std::abs(centre) > width / 2;  // else it allows for rounding of zero, which does not grow
  const double grown = is_relative ? std::max(1.0, std::abs(new_centre / centre)) : 1.0;
  return new_width > width * grown * (1 + 1e-6);  // rounding of the limits
}

/// Whether limits allow more than they did.
bool is_loosened(const Verdict& before, const Verdict& after) {
  const bool is_baseline = before.author.starts_with("baseline");
  if (is_baseline && before.lower && before.upper && after.lower && after.upper) return allows_more(before, after);
  const bool upper = before.upper && (!after.upper || *after.upper > *before.upper);
  const bool lower = before.lower && (!after.lower || *after.lower < *before.lower);
  return upper || lower;
}

}  // namespace

Reason compare_verdicts(const Verdict& before, const Verdict& after) {
  if (after.kind == vnv::Kind::cost) return {Change::unjudged, "machine-dependent"};
  const int rise = rank_of(after.outcome) - rank_of(before.outcome);
  if (rise < 0 && is_left_for_the_better(before, after))
    return {Change::better, "better than its baseline allows; to be accepted"};
  const std::string words = fmt::format("{} before, {} now", predicate_of(before.outcome), predicate_of(after.outcome));
  if (rise < 0) return {Change::worse, words};
  if (is_loosened(before, after)) return {Change::inconclusive, words + ", by limits that allow more"};
  return {rise > 0 ? Change::better : Change::same, words};
}

}  // namespace touchstone::gate
