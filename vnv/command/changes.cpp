#include "vnv/command/changes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace touchstone::vnv::command {
namespace {

const Baseline* same_place(const Baselines& among, const Baseline& row) {
  return among.find(row.method, row.level, row.time, row.quantity);
}

bool is_equal(const Baseline& a, const Baseline& b) {
  return a.value == b.value && a.lower == b.lower && a.upper == b.upper;
}

std::string values(const BaselineChange& change) {
  if (!change.before) return fmt::format("{:.6g}, new", change.after->value);
  if (!change.after) return fmt::format("{:.6g}, gone", change.before->value);
  const double margin = change.margin();
  return fmt::format("{:.6g} -> {:.6g}, margin {:.2g} of the old tolerance{}", change.before->value,
                     change.after->value, margin, margin >= 0 ? "" : ", beyond it");
}

}  // namespace

double BaselineChange::margin() const {
  if (!before || !after) return std::numeric_limits<double>::quiet_NaN();
  const double moved = after->value - before->value;
  if (moved == 0) return 1;
  return 1 - std::abs(moved) / (moved > 0 ? before->upper - before->value : before->value - before->lower);
}

std::string BaselineChange::sentence(const std::string& case_name) const {
  const Baseline& row = after ? *after : *before;
  std::string place = fmt::format("{}.{}", case_name, row.method);
  if (!row.level.empty()) place += " " + row.level;
  if (!std::isnan(row.time)) place += fmt::format(", {:g} s", row.time);
  return fmt::format("{}, {}: {}", place, row.quantity, values(*this));
}

std::vector<BaselineChange> changes(const Baselines& before, const Baselines& after) {
  std::vector<BaselineChange> found;
  for (const Baseline& row : after.rows) {
    const Baseline* old = same_place(before, row);
    if (!old)
      found.push_back({std::nullopt, row});
    else if (!is_equal(*old, row))
      found.push_back({*old, row});
  }
  for (const Baseline& row : before.rows)
    if (!same_place(after, row)) found.push_back({row, std::nullopt});
  return found;
}

}  // namespace touchstone::vnv::command
