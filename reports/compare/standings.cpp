#include "reports/compare/standings.hpp"

#include "vnv/record/end_of_run.hpp"
#include "vnv/record/same_time.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace touchstone::reports {
namespace {

bool is_measured(const vnv::Value& value, const Work& work) {
  return value.quantity == work.diagram.quantity && std::isfinite(value.value);
}

/// The last time counts, then the finest run.
std::optional<vnv::Value> error_at_end(const vnv::Record& record, const Work& work) {
  std::optional<vnv::Value> last;
  for (const vnv::Value& value : record.values)
    if (is_measured(value, work) &&
        (!last || std::tuple(value.time, -value.spacing) >= std::tuple(last->time, -last->spacing)))
      last = value;
  return last;
}

double smallest_error(const vnv::Record& record, const Work& work) {
  double least = INFINITY;
  for (const vnv::WorkPoint& point : vnv::of_series(work.points, record.method))
    if (point.error > 0) least = std::min(least, point.error);
  for (const vnv::Value& value : record.values)  // also of files that were judged, which have no run time
    if (is_measured(value, work) && vnv::same_time(value.time, work.time))
      least = std::min(least, std::abs(value.value));
  return std::isfinite(least) ? least : vnv::not_a_number;
}

std::optional<vnv::ObservedOrder> longest_ladder(const vnv::Record& record, const Work& work) {
  std::optional<vnv::ObservedOrder> longest;
  for (const vnv::ObservedOrder& order : record.orders)
    if (Subject{work.diagram.quantity.heading(), work.time}.is(order.quantity, order.time) &&
        (!longest || order.spacings.size() > longest->spacings.size()))
      longest = order;
  return longest;
}

/// The smallest of what some have; a method that fails is not called best.
void mark_best(std::vector<Standing>& methods, auto value, bool Standing::*is_best) {
  Standing* best = nullptr;
  for (Standing& one : methods) {
    if (tally(one.record->verdicts).fails > 0 || !(value(one) > 0)) continue;
    if (!best || value(one) < value(*best)) best = &one;
  }
  if (best && methods.size() > 1) best->*is_best = true;
}

}  // namespace

bool says_right(const vnv::Verdict& v, const std::optional<Work>& work) {
  if (v.author.starts_with("baseline")) return false;
  if (!work) return v.quantity != vnv::end_time_reached && v.kind != vnv::Kind::count;
  if (v.kind == vnv::Kind::order)
    return v.lower > 0 && v.trend != vnv::Trend::stalled && v.trend != vnv::Trend::diverging;
  return v.upper && (v.kind == vnv::Kind::norm || v.quantity == work->diagram.quantity.name);
}

bool Standing::converges() const {
  return std::ranges::find(right_by, vnv::Kind::order, &vnv::Verdict::kind) != right_by.end();
}

Standings standings_of(const CaseRecords& records) {
  Standings all{&records, work_of(records), {}};
  if (all.work && std::isnan(all.work->diagram.ranked_by) && !all.work->diagram.targets.empty())
    all.work->diagram.ranked_by = all.work->diagram.targets.back();
  for (const vnv::Record& record : records.records) {
    Standing one{.record = &record};
    for (const vnv::Verdict& v : record.verdicts)
      if (v.outcome == vnv::Outcome::holds && says_right(v, all.work)) one.right_by.push_back(v);
    if (all.work) {
      one.error = smallest_error(record, *all.work);
      one.at_end = error_at_end(record, *all.work);
      one.order = longest_ladder(record, *all.work);
      one.cost = vnv::time_to_error(vnv::of_series(all.work->points, record.method), all.work->diagram.ranked_by);
    }
    all.methods.push_back(std::move(one));
  }
  const auto error = [](const Standing& s) { return s.error; };
  const auto cpu = [](const Standing& s) { return s.cost.cpu; };
  const auto or_last = [](double value) { return std::isnan(value) ? INFINITY : value; };
  std::ranges::stable_sort(all.methods, {},
                           [&](const Standing& s) { return std::pair(or_last(cpu(s)), or_last(error(s))); });
  mark_best(all.methods, error, &Standing::is_most_accurate);
  mark_best(all.methods, cpu, &Standing::is_cheapest);
  return all;
}

}  // namespace touchstone::reports
