#include "vnv/gate/compare_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::gate {
namespace {

using vnv::Better;

/// A baseline this wide, as a fraction of its value, is a declaration that the value cannot be compared.
constexpr double incomparable = 0.5;

/// By how much it moved the worse way, in its own unit; negative if the better way. Only for a known direction.
double worsening(double before, double after, Better better) {
  if (better == Better::larger) return before - after;
  if (better == Better::smaller) return after - before;
  return std::abs(after) - std::abs(before);
}

std::string by_how_much(double before, double after) {
  const double relative = (after - before) / std::abs(before);
  return std::abs(relative) < 10 ? fmt::format("by {:+.3g} %", 100 * relative)
                                 : fmt::format("from {:.3g} to {:.3g}", before, after);
}

Reason compare_with_none(double before, double after) {
  if (!std::isfinite(before) && !std::isfinite(after)) return {Change::same, "no finite number before and after"};
  if (!std::isfinite(after)) return {Change::worse, "no finite number any more"};
  return {Change::better, "a finite number where there was none"};
}

}  // namespace

Reason compare_values(double before, double after, Better better, std::optional<double> tolerance) {
  if (!std::isfinite(before) || !std::isfinite(after)) return compare_with_none(before, after);
  if (before == after) return {Change::same, "equal"};
  const double moved = std::abs(after - before), scale = std::abs(before);
  const double allowed = tolerance.value_or(allowed_by_default * scale);
  const std::string change = by_how_much(before, after);
  const double believed = std::max(std::min(allowed, noticed * scale * (1 - 1e-6)), rounding_of_zero);
  if (moved <= believed) return {Change::same, change + ", which is allowed"};
  const bool is_known = better != Better::undeclared;
  const bool is_better = is_known && worsening(before, after, better) < 0;
  if (moved <= allowed) {
    const std::string why = fmt::format("{}; its baseline allows {:.3g}", change, allowed);
    if (allowed >= incomparable * scale) return {Change::unjudged, why + ", too much to compare"};
    return {is_better ? Change::same : Change::inconclusive, why};
  }
  const std::string why = fmt::format("{}; allowed are {:.3g}", change, std::max(allowed, rounding_of_zero));
  if (!is_known) return {Change::inconclusive, why + "; which way is better is not declared"};
  return {is_better ? Change::better : Change::worse, why};
}

}  // namespace touchstone::gate
