#include "vnv/judge/claims.hpp"

#include <fmt/format.h>

#include <cmath>

namespace touchstone::vnv {
namespace {

std::string limits_of(const Verdict& v) {
  if (v.lower && v.upper) return fmt::format("expected in [{:.6g}, {:.6g}]", *v.lower, *v.upper);
  if (v.upper) return fmt::format("limit {:.6g}", *v.upper);
  return v.lower ? fmt::format("expected at least {:.6g}", *v.lower) : "no limit";
}

std::string in_capitals(Outcome outcome) {
  return outcome == Outcome::holds ? "HOLDS" : outcome == Outcome::fails ? "FAILS" : "INCONCLUSIVE";
}

Verdict verdict_of(const Claim& claim, const Place& place, double value) {
  const Quantity quantity = judged_quantity(claim);
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
  v.surely_above = claim.surely_above;
  v.author = claim.author.words;
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

/// Concludes from all that the verdict holds by now.
Verdict concluded(Verdict v, std::string_view remark) {
  v.outcome = outcome_of(v);
  v.margin = margin_of(v);
  const std::string unit = v.unit.empty() ? "" : " " + v.unit;
  v.sentence = fmt::format("{}, {}{} ({}), margin {:.0f} %: {}", value_in_words(v, remark), limits_of(v), unit,
                           v.author, 100 * v.margin, in_capitals(v.outcome));
  return v;
}

/// ", asymptotic" where the interval, of at most 0.2 to each side, holds the formal order and the finest pairs agree;
/// else on which side of it the order is.
std::string beside_formal_order(const Claim& claim, const Verdict& v, const ObservedOrder& order) {
  if (!claim.formal_order) return "";
  constexpr double widest = 0.2;
  const double formal = *claim.formal_order, wide = *v.half_width;
  if (std::abs(v.value - formal) > wide)
    return fmt::format(", {} the formal order {:g}, not asymptotic", v.value > formal ? "above" : "below", formal);
  return order.asymptotic && wide <= widest ? ", asymptotic" : ", not asymptotic";
}

Verdict judge_slope(const Claim& claim, const Place& place, const ObservedOrder& order) {
  Verdict v = verdict_of(claim, place, order.order);
  v.half_width = order.half_width;
  v.trend = order.trend;
  const std::string remark = fmt::format(" +- {:.2g} over {} levels{}", order.half_width, order.levels.size(),
                                         beside_formal_order(claim, v, order));
  return concluded(std::move(v), remark);
}

Verdict judge_convergence(const Claim& claim, const Place& place, const ObservedOrder& order) {
  const bool above_floor = !std::isnan(order.floor);
  Verdict v = verdict_of(claim, place, above_floor ? order.order_to_floor : order.order);
  v.half_width = above_floor ? order.order_to_floor_half_width : order.half_width;
  v.trend = order.trend;
  const std::string floor = above_floor ? fmt::format(" above a floor of {:.3g}", order.floor) : "";
  const std::string remark =
      fmt::format(" +- {:.2g} over {} levels{}, {}{}, expected surely above {:g}", *v.half_width, order.levels.size(),
                  floor, word_of(order.trend), beside_formal_order(claim, v, order), *claim.surely_above);
  return concluded(std::move(v), remark);
}

}  // namespace

Quantity judged_quantity(const Claim& claim) {
  if (claim.ladder.empty()) return claim.quantity;
  return {fmt::format("order of {} over {}", claim.quantity.name, claim.ladder), "", Kind::order};
}

bool Claim::covers(std::string_view its_level, double its_time) const {
  return (level.empty() || level == its_level) &&
         (std::isnan(time) || std::abs(time - its_time) <= 1e-9 * std::abs(time));
}

Verdict judge(const Claim& claim, const Place& place, double value) {
  return concluded(verdict_of(claim, place, value), "");
}

Verdict judge(const Claim& claim, const Place& place, const ObservedOrder& order) {
  return claim.surely_above ? judge_convergence(claim, place, order) : judge_slope(claim, place, order);
}

}  // namespace touchstone::vnv
