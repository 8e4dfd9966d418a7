#include "vnv/gate/comparison.hpp"

#include "vnv/gate/compare_orders.hpp"
#include "vnv/gate/compare_values.hpp"
#include "vnv/gate/compare_verdicts.hpp"
#include "vnv/gate/places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace touchstone::gate {
namespace {

using vnv::Value, vnv::ObservedOrder, vnv::Record, vnv::RunSummary, vnv::Verdict;

const char* const gone = "no longer there";
const char* const added = "new";

/// A thing of a method, before it is judged.
Difference of_method(const Record& record, Kind kind, std::string quantity) {
  Difference d;
  d.case_name = record.case_name;
  d.method = record.method;
  d.kind = kind;
  d.quantity = std::move(quantity);
  return d;
}

Difference concluded(Difference d, Reason reason) {
  d.change = reason.first;
  d.why = std::move(reason.second);
  return d;
}

/// Goes through what two lists hold: `judge(item of before, that of after or null)` and `tell(item that is new)`.
template <class Item>
void match(const std::vector<Item>& before, const std::vector<Item>& after, const auto& is_same, const auto& judge,
           const auto& tell) {
  for (const Item& item : before) {
    const auto found = std::ranges::find_if(after, [&](const Item& other) { return is_same(item, other); });
    judge(item, found == after.end() ? nullptr : &*found);
  }
  for (const Item& item : after)
    if (std::ranges::none_of(before, [&](const Item& other) { return is_same(other, item); })) tell(item);
}

class Comparison {
 public:
  void compare_methods(const Record& before, const Record& after) {
    compare_runs(before, after);
    compare_claims(before, after);
    compare_errors(before, after);
    compare_orders_of(before, after);
  }

  void tell(Difference d, Reason reason) { found_.push_back(concluded(std::move(d), std::move(reason))); }

  std::vector<Difference> take() { return std::move(found_); }

 private:
  void compare_runs(const Record& before, const Record& after) {
    const auto place = [&](const RunSummary& run) {
      Difference d = of_method(before, Kind::run, "run");
      d.level = run.level;
      d.time = run.end_time;
      return d;
    };
    match(
        before.runs, after.runs, [](const RunSummary& a, const RunSummary& b) { return a.level == b.level; },
        [&](const RunSummary& was, const RunSummary* is) {
          tell(place(was), is ? compare_ends(was, *is) : Reason{Change::worse, gone});
        },
        [&](const RunSummary& is) {
          tell(place(is), {Change::unjudged, added});
        });
  }

  static Reason compare_ends(const RunSummary& before, const RunSummary& after) {
    if (before.finished && !after.finished) return {Change::worse, after.outcome};
    if (!before.finished && after.finished) return {Change::better, "ends now; before: " + before.outcome};
    if (before.finished && after.end_time < before.end_time * (1 - 1e-9))
      return {Change::worse, fmt::format("ends at {:.6g} s now", after.end_time)};
    return {Change::same, after.finished ? "ends" : after.outcome};
  }

  void compare_errors(const Record& before, const Record& after) {
    const auto place = [&](const Value& error) {
      Difference d = of_method(before, kind_of(error.quantity.kind), error.quantity.heading());
      d.level = error.level;
      d.time = error.time;
      return d;
    };
    for (const Value& was : before.values) {
      const Value* is = find_value(after, was);
      Difference d = place(is ? *is : was);  // records of a former schema declare no kind
      d.before = was.value;
      if (is) d.after = is->value;
      tell(std::move(d), is ? compare_error(was, *is, before) : Reason{Change::worse, gone});
    }
    for (const Value& is : after.values)
      if (!find_value(before, is)) {
        Difference d = place(is);
        d.after = is.value;
        tell(std::move(d), {Change::unjudged, added});
      }
  }

  static Reason compare_error(const Value& was, const Value& is, const Record& before) {
    if (is.quantity.kind == vnv::Kind::cost) return {Change::unjudged, "of the machine"};
    return compare_values(was.value, is.value, is.quantity.better, room_of(was, before));
  }

  void compare_orders_of(const Record& before, const Record& after) {
    const auto place = [&](const ObservedOrder& order) {
      Difference d = of_method(before, Kind::order, fmt::format("order of {} over {}", order.quantity, order.ladder));
      d.time = order.time;
      return d;
    };
    const auto is_same = [](const ObservedOrder& a, const ObservedOrder& b) {
      return a.ladder == b.ladder && a.quantity == b.quantity && same_time(a.time, b.time);
    };
    match(
        before.orders, after.orders, is_same,
        [&](const ObservedOrder& was, const ObservedOrder* is) {
          Difference d = place(was);
          d.before = was.order;
          if (is) d.after = is->order;
          tell(std::move(d),
               is ? compare_orders(was, *is, explained_by_tolerance(was, before)) : Reason{Change::worse, gone});
        },
        [&](const ObservedOrder& is) {
          tell(place(is), {Change::unjudged, added});
        });
  }

  /// By how much an order moves while all its errors keep within what they may move by and nobody has to notice.
  static double explained_by_tolerance(const ObservedOrder& order, const Record& record) {
    double share = 0;
    for (std::size_t k = 0; k < order.errors.size(); ++k) {
      const Value place{order.levels.at(k), order.spacings.at(k), order.time, vnv::with_heading(order.quantity)};
      const double scale = std::abs(order.errors[k]);
      const double room = room_of(place, record).value_or(allowed_by_default * scale);
      share = std::max(share, std::min(room / scale, noticed));
    }
    return tilt_by(share, order.spacings);
  }

  /// Claims of one quantity, place and kind of author are told apart by how many came before.
  struct Claimed {
    const Verdict* verdict;
    std::string author;  // "theory", "literature" or "baseline"
    long ordinal = 0;

    bool is_same(const Claimed& other) const {
      return author == other.author && verdict->quantity == other.verdict->quantity &&
             verdict->level == other.verdict->level && same_time(verdict->time, other.verdict->time);
    }
  };

  static std::vector<Claimed> claims_of(const Record& record) {
    std::vector<Claimed> claims;
    for (const Verdict& verdict : record.verdicts) {
      Claimed claim{&verdict, verdict.author.substr(0, verdict.author.find(':'))};
      claim.ordinal = std::ranges::count_if(claims, [&](const Claimed& other) { return claim.is_same(other); });
      claims.push_back(std::move(claim));
    }
    return claims;
  }

  void compare_claims(const Record& before, const Record& after) {
    const auto place = [&](const Claimed& claim) {
      const Verdict& v = *claim.verdict;
      Difference d = of_method(before, Kind::claim, fmt::format("claim on {} ({})", v.quantity, v.author));
      d.level = v.level;
      d.time = v.time;
      d.before = v.value;
      return d;
    };
    match(
        claims_of(before), claims_of(after),
        [](const Claimed& a, const Claimed& b) { return a.ordinal == b.ordinal && a.is_same(b); },
        [&](const Claimed& was, const Claimed* is) {
          Difference d = place(was);
          if (is) d.after = is->verdict->value;
          tell(std::move(d), is ? compare_verdicts(*was.verdict, *is->verdict) : Reason{Change::worse, gone});
        },
        [&](const Claimed& is) {
          tell(place(is), {Change::unjudged, added});
        });
  }

  std::vector<Difference> found_;
};

bool are_of_one_method(const Record& a, const Record& b) { return a.case_name == b.case_name && a.method == b.method; }

void require_one_of_each(const Records& records) {
  for (std::size_t i = 0; i < records.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (are_of_one_method(records[i], records[k]))
        throw std::invalid_argument(
            fmt::format("{}.{}: two records, expected one", records[i].case_name, records[i].method));
}

bool are_at_one_place(const Difference& a, const Difference& b) {
  return a.case_name == b.case_name && a.method == b.method && a.kind == b.kind && a.level == b.level &&
         a.quantity == b.quantity && same_time(a.time, b.time);
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
  Comparison comparison;
  match(
      before, after, are_of_one_method,
      [&](const Record& was, const Record* is) {
        if (is) return comparison.compare_methods(was, *is);
        comparison.tell(of_method(was, Kind::run, "method"), {Change::worse, gone});
      },
      [&](const Record& is) {
        comparison.tell(of_method(is, Kind::run, "method"), {Change::unjudged, added});
      });
  return comparison.take();
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
