#include "vnv/gate/comparison.hpp"

#include "vnv/gate/compare_orders.hpp"
#include "vnv/gate/compare_values.hpp"
#include "vnv/gate/compare_verdicts.hpp"
#include "vnv/record/same_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace touchstone::gate {
namespace {

using vnv::Value, vnv::ObservedOrder, vnv::Record, vnv::RunSummary, vnv::Verdict;

/// A thing of a method, before it is judged.
Difference of_method(const Record& record, Kind kind, std::string quantity, double time, std::string level = "") {
  return {.case_name = record.case_name,
          .method = record.method,
          .level = std::move(level),
          .time = time,
          .quantity = std::move(quantity),
          .kind = kind};
}

Difference concluded(Difference d, Reason reason) {
  d.change = reason.first;
  d.why = std::move(reason.second);
  return d;
}

/// What two lists hold, item by item of before, then what is new. `is_same` pairs them; `place(item, its partner or
/// null)` says where a thing stands, `value(item)` its number, `judge(before, after)` which way it went.
template <class Item>
void compare_lists(const std::vector<Item>& before, const std::vector<Item>& after, const auto& is_same,
                   const auto& place, const auto& value, const auto& judge, std::vector<Difference>& found) {
  for (const Item& was : before) {
    const auto at = std::ranges::find_if(after, [&](const Item& other) { return is_same(was, other); });
    const Item* is = at == after.end() ? nullptr : &*at;
    Difference d = concluded(place(was, is), is ? judge(was, *is) : Reason{Change::worse, gone});
    d.before = value(was);
    if (is) d.after = value(*is);
    found.push_back(std::move(d));
  }
  for (const Item& is : after) {
    if (std::ranges::any_of(before, [&](const Item& other) { return is_same(other, is); })) continue;
    found.push_back(concluded(place(is, nullptr), {Change::unjudged, added}));
    found.back().after = value(is);
  }
}

/// Whether two values are of one quantity, level and time.
bool is_same_value(const Value& a, const Value& b) {
  return a.level == b.level && a.quantity.name == b.quantity.name && a.quantity.unit == b.quantity.unit &&
         vnv::same_time(a.time, b.time);
}

/// How far a value may move [its own unit]: half the width between the limits of its baseline, the narrowest of them;
/// nothing where it has none.
std::optional<double> tolerance_of(const Value& error, const Record& record) {
  std::optional<double> tolerance;
  for (const Verdict& v : record.verdicts) {
    if (!v.author.starts_with("baseline") || !v.lower || !v.upper || !std::isfinite(*v.upper - *v.lower)) continue;
    if (v.level != error.level || v.quantity != error.quantity.name || !vnv::same_time(v.time, error.time)) continue;
    const double half = (*v.upper - *v.lower) / 2;
    if (!tolerance || half < *tolerance) tolerance = half;
  }
  return tolerance;
}

Reason compare_ends(const RunSummary& before, const RunSummary& after) {
  if (before.finished && !after.finished) return {Change::worse, after.outcome};
  if (!before.finished && after.finished) return {Change::better, "ends now; before: " + before.outcome};
  if (before.finished && after.end_time < before.end_time * (1 - 1e-9))
    return {Change::worse, fmt::format("ends at {:.6g} s now", after.end_time)};
  return {Change::same, after.finished ? "ends" : after.outcome};
}

void compare_runs(const Record& before, const Record& after, std::vector<Difference>& found) {
  const auto place = [&](const RunSummary& run, const RunSummary*) {
    return of_method(before, Kind::run, "run", run.end_time, run.level);
  };
  compare_lists(
      before.runs, after.runs, [](const RunSummary& a, const RunSummary& b) { return a.level == b.level; }, place,
      [](const RunSummary&) { return vnv::not_a_number; }, compare_ends, found);
}

void compare_errors(const Record& before, const Record& after, std::vector<Difference>& found) {
  const auto place = [&](const Value& error, const Value* now) {  // records of a former schema declare no kind
    const Kind kind = kind_of((now ? now : &error)->quantity.kind);
    return of_method(before, kind, error.quantity.heading(), error.time, error.level);
  };
  const auto judge = [&](const Value& was, const Value& is) {
    if (is.quantity.kind == vnv::Kind::cost) return Reason{Change::unjudged, "machine-dependent"};
    return compare_values(was.value, is.value, is.quantity.better, tolerance_of(was, before));
  };
  compare_lists(
      before.values, after.values, is_same_value, place, [](const Value& error) { return error.value; }, judge, found);
}

/// By how much an order moves while all its errors keep within what they may move by and nobody has to notice.
double explained_by_tolerance(const ObservedOrder& order, const Record& record) {
  double fraction = 0;
  for (std::size_t k = 0; k < order.errors.size(); ++k) {
    const Value place{order.levels.at(k), order.spacings.at(k), order.time, vnv::with_heading(order.quantity)};
    const double scale = std::abs(order.errors[k]);
    const double tolerance = tolerance_of(place, record).value_or(allowed_by_default * scale);
    fraction = std::max(fraction, std::min(tolerance / scale, noticed));
  }
  return tilt_by(fraction, order.spacings);
}

void compare_orders_of(const Record& before, const Record& after, std::vector<Difference>& found) {
  const auto is_same = [](const ObservedOrder& a, const ObservedOrder& b) {
    return a.ladder == b.ladder && a.quantity == b.quantity && vnv::same_time(a.time, b.time);
  };
  const auto place = [&](const ObservedOrder& order, const ObservedOrder*) {
    return of_method(before, Kind::order, fmt::format("order of {} over {}", order.quantity, order.ladder), order.time);
  };
  const auto judge = [&](const ObservedOrder& was, const ObservedOrder& is) {
    return compare_orders(was, is, explained_by_tolerance(was, before));
  };
  compare_lists(
      before.orders, after.orders, is_same, place, [](const ObservedOrder& order) { return order.order; }, judge,
      found);
}

/// Claims of one quantity, place and kind of author are distinguished by how many came before.
struct Claimed {
  const Verdict* verdict;
  std::string author;  // "theory", "literature" or "baseline"
  long ordinal = 0;

  bool is_same(const Claimed& other) const {
    return author == other.author && verdict->quantity == other.verdict->quantity &&
           verdict->level == other.verdict->level && vnv::same_time(verdict->time, other.verdict->time);
  }
};

std::vector<Claimed> claims_of(const Record& record) {
  std::vector<Claimed> claims;
  for (const Verdict& verdict : record.verdicts) {
    if (verdict.quantity == vnv::never_accepted) continue;  // gone once they are accepted, which is no loss
    Claimed claim{&verdict, verdict.author.substr(0, verdict.author.find(':'))};
    claim.ordinal = std::ranges::count_if(claims, [&](const Claimed& other) { return claim.is_same(other); });
    claims.push_back(std::move(claim));
  }
  return claims;
}

void compare_claims(const Record& before, const Record& after, std::vector<Difference>& found) {
  const auto is_same = [](const Claimed& a, const Claimed& b) { return a.ordinal == b.ordinal && a.is_same(b); };
  const auto place = [&](const Claimed& claim, const Claimed*) {
    const Verdict& v = *claim.verdict;
    return of_method(before, Kind::claim, fmt::format("claim on {} ({})", v.quantity, v.author), v.time, v.level);
  };
  compare_lists(
      claims_of(before), claims_of(after), is_same, place, [](const Claimed& claim) { return claim.verdict->value; },
      [](const Claimed& was, const Claimed& is) { return compare_verdicts(*was.verdict, *is.verdict); }, found);
}

/// Of what differs between two machines, which they are; by one program the value depends on the machine.
void name_machines(const Record& before, const Record& after, Difference& d) {
  if (before.machine == after.machine || d.change <= Change::same) return;
  d.why += fmt::format("; {}: {} before, {} after",
                       before.revision == after.revision ? "this value depends on the machine" : "on another machine",
                       before.machine, after.machine);
}

void require_one_of_each(const Records& records) {
  for (std::size_t i = 0; i < records.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (are_of_one_method(records[i], records[k]))
        throw std::invalid_argument(
            fmt::format("{}.{}: two records, expected one", records[i].case_name, records[i].method));
}

bool are_at_one_place(const Difference& a, const Difference& b) {
  return are_of_one_method(a, b) && a.kind == b.kind && a.level == b.level && a.quantity == b.quantity &&
         vnv::same_time(a.time, b.time);
}

/// What is not the same in all runs of one program.
std::vector<Difference> unsteady_among(const std::vector<Records>& runs) {
  std::vector<Difference> unsteady;
  for (std::size_t k = 1; k < runs.size(); ++k)
    for (Difference& d : compare(runs.front(), runs[k])) {
      const bool is_equal = d.before == d.after || (std::isnan(d.before) && std::isnan(d.after));
      if (d.change > Change::same || !is_equal) unsteady.push_back(std::move(d));
    }
  return unsteady;
}

}  // namespace

std::vector<Difference> compare(const Records& before, const Records& after) {
  require_one_of_each(before);
  require_one_of_each(after);
  std::vector<Difference> found;
  for (const Record& was : before) {
    const auto is = std::ranges::find_if(after, [&](const Record& other) { return are_of_one_method(was, other); });
    if (is == after.end()) {
      found.push_back(of_whole_method(was.case_name, was.method, Change::worse));
      continue;
    }
    const auto first = std::ssize(found);
    for (const auto compare_all : {compare_runs, compare_claims, compare_errors, compare_orders_of})
      compare_all(was, *is, found);
    std::for_each(found.begin() + first, found.end(), [&](Difference& d) { name_machines(was, *is, d); });
  }
  for (const Record& is : after)
    if (std::ranges::none_of(before, [&](const Record& other) { return are_of_one_method(other, is); }))
      found.push_back(of_whole_method(is.case_name, is.method, Change::unjudged));
  return found;
}

std::vector<Difference> compare_repeated(const std::vector<Records>& before, const std::vector<Records>& after) {
  const std::vector<Difference> unsteady_before = unsteady_among(before), unsteady_after = unsteady_among(after);
  const auto is_among = [](const Difference& d, const std::vector<Difference>& list) {
    return std::ranges::any_of(list, [&](const Difference& other) { return are_at_one_place(d, other); });
  };
  std::vector<Difference> found = compare(before.front(), after.front());
  for (Difference& d : found) {
    if (is_among(d, unsteady_before))
      d = concluded(std::move(d), {Change::unjudged, "not the same in all runs before"});
    else if (is_among(d, unsteady_after) && d.change < Change::inconclusive)
      d = concluded(std::move(d), {Change::inconclusive, "no longer the same in all runs"});
  }
  return found;
}

}  // namespace touchstone::gate
