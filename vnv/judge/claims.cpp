#include "vnv/judge/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::vnv {
namespace {

/// Fraction of a limit that is left, or of half the width between two.
double margin_of(const Claim& claim, double value) {
  if (claim.lower && claim.upper) {
    const double half = (*claim.upper - *claim.lower) / 2;
    return std::min(*claim.upper - value, value - *claim.lower) / (half > 0 ? half : 1);
  }
  if (claim.upper) return (*claim.upper - value) / (*claim.upper != 0 ? std::abs(*claim.upper) : 1);
  return (value - *claim.lower) / (*claim.lower != 0 ? std::abs(*claim.lower) : 1);
}

std::string limits_of(const Claim& claim) {
  if (claim.lower && claim.upper) return fmt::format("expected in [{:.6g}, {:.6g}]", *claim.lower, *claim.upper);
  return claim.upper ? fmt::format("limit {:.6g}", *claim.upper)
                     : fmt::format("expected at least {:.6g}", *claim.lower);
}

std::string word_of(Outcome outcome) {
  return outcome == Outcome::holds ? "HOLDS" : outcome == Outcome::fails ? "FAILS" : "INCONCLUSIVE";
}

Quantity order_of(const Quantity& quantity, const std::string& ladder) {
  return {fmt::format("order of {} over {}", quantity.name, ladder), "", Kind::order};
}

Verdict verdict_of(const Claim& claim, const Place& place, double value) {
  const Quantity quantity = claim.ladder.empty() ? claim.quantity : order_of(claim.quantity, claim.ladder);
  Verdict v;
  v.case_name = place.case_name;
  v.method = place.method;
  v.level = place.level;
  v.spacing = place.spacing;
  v.time = place.time;
  v.quantity = quantity.name;
  v.unit = quantity.unit;
  v.kind = quantity.kind;
  v.better = quantity.better;
  v.value = value;
  v.lower = claim.lower;
  v.upper = claim.upper;
  v.author = claim.author.words;
  v.margin = margin_of(claim, value);
  return v;
}

/// "poiseuille.mpm M2: L2 v_x = 0.0641 % at 1 s", with a remark behind the value.
std::string value_in_words(const Verdict& v, std::string_view remark = "") {
  const std::string level = v.level.empty() ? "" : " " + v.level;
  const std::string unit = v.unit.empty() ? "" : " " + v.unit;
  const std::string time = std::isnan(v.time) ? "" : fmt::format(" at {:.4g} s", v.time);
  return fmt::format("{}.{}{}: {} = {:.6g}{}{}{}", v.case_name, v.method, level, v.quantity, v.value, unit, remark,
                     time);
}

void conclude(Verdict& v, const Claim& claim, Outcome outcome, std::string_view remark) {
  v.outcome = outcome;
  const std::string unit = v.unit.empty() ? "" : " " + v.unit;
  v.sentence = fmt::format("{}, {}{} ({}), margin {:.0f} %: {}", value_in_words(v, remark), limits_of(claim), unit,
                           v.author, 100 * v.margin, word_of(outcome));
}

bool within(const Claim& claim, double value) {
  return (!claim.lower || value >= *claim.lower) && (!claim.upper || value <= *claim.upper) && !std::isnan(value);
}

/// Beyond this half-width an interval does not part orders 1 and 2 from their neighbours.
constexpr double widest = 0.3;

Verdict judge_slope(const Claim& claim, const Place& place, const ObservedOrder& order) {
  Verdict v = verdict_of(claim, place, order.order);
  const bool sure = std::isnan(order.order) || order.half_width < widest;
  conclude(v, claim,
           !sure                        ? Outcome::inconclusive
           : within(claim, order.order) ? Outcome::holds
                                        : Outcome::fails,
           fmt::format(" +- {:.2g} over {} levels", order.half_width, order.levels.size()));
  return v;
}

Outcome outcome_of_convergence(const Claim& claim, const ObservedOrder& order, double slope, double half_width) {
  if (order.trend == Trend::inconclusive) return std::isnan(slope) ? Outcome::fails : Outcome::inconclusive;
  if (order.trend != Trend::converging) return Outcome::fails;
  if (!(half_width < widest)) return Outcome::inconclusive;
  return within(claim, slope) && slope - half_width > *claim.surely_above ? Outcome::holds : Outcome::fails;
}

Verdict judge_convergence(const Claim& claim, const Place& place, const ObservedOrder& order) {
  const bool above_floor = !std::isnan(order.floor);
  const double slope = above_floor ? order.order_to_floor : order.order;
  const double half_width = above_floor ? order.order_to_floor_half_width : order.half_width;
  Verdict v = verdict_of(claim, place, slope);
  const std::string floor = above_floor ? fmt::format(" above a floor of {:.3g}", order.floor) : "";
  conclude(v, claim, outcome_of_convergence(claim, order, slope, half_width),
           fmt::format(" +- {:.2g} over {} levels{}, {}, expected surely above {:g}", half_width, order.levels.size(),
                       floor, name_of(order.trend), *claim.surely_above));
  return v;
}

}  // namespace

bool Claim::covers(std::string_view its_level, double its_time) const {
  return (level.empty() || level == its_level) &&
         (std::isnan(time) || std::abs(time - its_time) <= 1e-9 * std::abs(time));
}

Verdict judge(const Claim& claim, const Place& place, double value) {
  Verdict v = verdict_of(claim, place, value);
  conclude(v, claim, within(claim, value) ? Outcome::holds : Outcome::fails, "");
  return v;
}

Verdict judge(const Claim& claim, const Place& place, const ObservedOrder& order) {
  return claim.surely_above ? judge_convergence(claim, place, order) : judge_slope(claim, place, order);
}

}  // namespace touchstone::vnv
