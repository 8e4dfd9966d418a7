#include "vnv/record/verdict.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::vnv {
namespace {

/// Beyond this half-width an interval does not part orders 1 and 2 from their neighbours.
constexpr double widest = 0.3;

bool is_within_limits(const Verdict& v) {
  return (!v.lower || v.value >= *v.lower) && (!v.upper || v.value <= *v.upper);
}

}  // namespace

Outcome outcome_of(const Verdict& v) {
  if (!v.lower && !v.upper) return Outcome::inconclusive;
  if (!v.half_width || std::isnan(v.value)) return is_within_limits(v) ? Outcome::holds : Outcome::fails;
  if (v.surely_above && (v.trend == Trend::stalled || v.trend == Trend::diverging)) return Outcome::fails;
  if (v.surely_above && v.trend != Trend::converging) return Outcome::inconclusive;
  const double low = v.value - *v.half_width;
  const bool is_sure = !v.surely_above || low > *v.surely_above, holds = is_within_limits(v) && is_sure;
  const bool lies_above = v.lower && !v.upper && low > (v.surely_above ? *v.surely_above : *v.lower);  // however wide
  if (!(*v.half_width < widest) && !(holds && lies_above)) return Outcome::inconclusive;
  return holds ? Outcome::holds : Outcome::fails;
}

double margin_of(const Verdict& v) {
  if (v.lower && v.upper) {
    const double half = (*v.upper - *v.lower) / 2;
    return std::min(*v.upper - v.value, v.value - *v.lower) / (half > 0 ? half : 1);
  }
  if (v.upper) return (*v.upper - v.value) / (*v.upper != 0 ? std::abs(*v.upper) : 1);
  return v.lower ? (v.value - *v.lower) / (*v.lower != 0 ? std::abs(*v.lower) : 1) : not_a_number;
}

}  // namespace touchstone::vnv
