#include "reports/pages/pages.hpp"

#include "reports/compare/standings.hpp"
#include "vnv/record/same_time.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>

namespace touchstone::reports {
namespace {

std::string counts(const Tally& t) {
  if (t.fails > 0) return fmt::format("{} of {} {}", t.fails, t.total(), t.fails == 1 ? "fails" : "fail");
  return fmt::format("{} of {} inconclusive", t.inconclusive, t.total());
}

/// What a method is called, and the class of its colour.
struct Name {
  std::string words, kind;
};

/// What keeps records of a case, which `is_its` knows by their claims, from being good; nothing where all claims hold.
std::optional<Name> flaw(const Tally& sum, const NightStatus& status, const auto& is_its) {
  if (sum.total() == 0) return Name{"no claim", word(sum.worst())};
  if (sum.fails > 0 && std::ranges::none_of(status.unknown, is_its)) return Name{counts(sum) + ", known", "known"};
  if (sum.worst() != vnv::Outcome::holds) return Name{counts(sum), word(sum.worst())};
  return std::nullopt;
}

/// What a method is called in a flow.
Name stands(const Standing& one, const NightStatus& status) {
  const auto is_its = [&](const vnv::Verdict& v) {
    return v.case_name == one.record->case_name && v.method == one.record->method;
  };
  if (auto found = flaw(tally(one.record->verdicts), status, is_its)) return *found;
  if (one.right_by.empty()) return {"as last accepted", "accepted"};
  return {one.converges() ? "converges" : "agrees", "holds"};
}

constexpr double far_off = 10;  // %

bool is_far_off(const vnv::Value& error) { return error.quantity.unit == "%" && std::abs(error.value) >= far_off; }

/// How wrong an accepted method is, with the time where it is not that of the flow.
Data wrong(const vnv::Value& error, double time) {
  return object("by"_ = rounded(std::abs(error.value), error.quantity.unit), "far"_ = is_far_off(error),
                "at"_ = when(!vnv::same_time(error.time, time), valued(error.time, "s")));
}

/// Theory, literature or both.
std::string authors(const std::vector<vnv::Verdict>& claims) {
  std::set<std::string> names;
  for (const vnv::Verdict& v : claims) names.insert(v.author.substr(0, v.author.find(':')));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// "2 / 0 / 16": claims by theory, literature and baselines.
std::string claims(const Tally& sum) {
  return fmt::format("{}\u2009/\u2009{}\u2009/\u2009{}", sum.theory, sum.literature, sum.baseline);
}

/// A method in a flow in which an error is measured.
Data method_data(const Standing& one, const Work& work, const NightStatus& status) {
  const Name name = stands(one, status);
  const bool has_order = one.order && !std::isnan(one.order->order);
  return object("method"_ = one.record->method, "is_most_accurate"_ = one.is_most_accurate,
                "error"_ = std::isnan(one.error) ? "–" : rounded(one.error, work.diagram.quantity.unit),
                "order"_ = has_order ? with_interval(one.order->order, one.order->half_width) : "–",
                "trend"_ = has_order ? word(one.order->trend) : "none", "is_cheapest"_ = one.is_cheapest,
                "cost"_ = one.cost.is_reached() ? rounded(one.cost) : "–", "kind"_ = name.kind, "name"_ = name.words,
                "wrong"_ = name.kind == "accepted" && one.at_end ? wrong(*one.at_end, work.time) : false,
                "authors"_ = when(name.kind == "holds", authors(one.right_by)),
                "claims"_ = claims(tally(one.record->verdicts)));
}

/// A picture of a case, its name, and what is measured in it.
Data case_data(const CaseRecords& records, const Data& measure) {
  return object("case"_ = records.name, "title"_ = records.title(), "image"_ = if_any(first_image(records)),
                "measure"_ = measure);
}

/// Adds a row of each method of a flow, the first with the flow.
void add_flow(List& rows, const Standings& all, const NightStatus& status) {
  const vnv::WorkDiagram& diagram = all.work->diagram;
  const auto target = when(!std::isnan(diagram.ranked_by), valued(diagram.ranked_by, diagram.quantity.unit));
  Data flow = case_data(*all.records, object("quantity"_ = diagram.quantity.name, "time"_ = valued(all.work->time, "s"),
                                             "target"_ = target));
  flow["rows"] = when(all.methods.size() > 1, all.methods.size());
  for (const Standing& one : all.methods) {
    rows.push_back(method_data(one, *all.work, status));
    rows.back()["flow"] = std::exchange(flow, false);
  }
}

/// A case in which no error is measured.
Data other_data(const Standings& all, const NightStatus& status) {
  const auto method = [&](const Standing& one) {
    return object("method"_ = one.record->method, "kind"_ = stands(one, status).kind);
  };
  const auto right = std::ranges::count_if(all.methods, [](const Standing& one) { return !one.right_by.empty(); });
  const Tally sum = tally(verdicts_of(*all.records));
  const auto found = flaw(sum, status, [&](const vnv::Verdict& v) { return v.case_name == all.records->name; });
  const Name name = found        ? *found
                    : right == 0 ? Name{"as last accepted", "accepted"}
                                 : Name{fmt::format("{} of {} agree", right, all.methods.size()), "holds"};
  return object("flow"_ = case_data(*all.records, false), "kind"_ = name.kind, "name"_ = name.words,
                "methods"_ = each(all.methods, method), "claims"_ = claims(sum));
}

/// The accepted methods that are farthest off, among errors in per cent.
Data most_wrong(const std::vector<Standings>& standings, const NightStatus& status) {
  constexpr std::size_t most = 8;
  std::vector<std::pair<double, Data>> found;
  for (const Standings& all : standings)
    for (const Standing& one : all.methods)
      if (one.at_end && is_far_off(*one.at_end) && stands(one, status).kind == "accepted")
        found.emplace_back(std::abs(one.at_end->value),
                           object("method"_ = one.record->method, "error"_ = rounded(std::abs(one.at_end->value), "%"),
                                  "case"_ = all.records->name, "title"_ = all.records->title()));
  if (found.empty()) return false;
  std::ranges::stable_sort(found, std::greater(), &std::pair<double, Data>::first);
  const auto items = std::span(found).first(std::min(found.size(), most));
  return object("by"_ = far_off, "count"_ = counted(std::ssize(found), "method"),
                "are_some_left_out"_ = items.size() < found.size(),
                "items"_ = each(items, [](const auto& one) { return one.second; }));
}

/// How many methods are what, by the class of their colour.
Data how_many(const std::vector<Standings>& standings, const NightStatus& status) {
  std::map<std::string, long> counts;
  for (const Standings& all : standings)
    for (const Standing& one : all.methods) ++counts[stands(one, status).kind];
  Data numbers;
  for (const char* kind : {"holds", "accepted", "inconclusive", "known", "fails"})
    numbers[kind] = when(counts[kind] > 0, counts[kind]);
  return numbers;
}

/// Error against run time in one flow, as on its own page: that of the picture in README, or else the one with most
/// runs.
Data work_figure(const std::vector<Standings>& standings) {
  const auto merit = [](const Standings& all) {
    const bool is_drawn = all.work && !all.work->diagram.id.empty();
    return std::tuple(is_drawn, all.records->name.starts_with("poiseuille"), is_drawn ? all.work->points.size() : 0);
  };
  const Standings& best = *std::ranges::max_element(standings, {}, merit);
  if (!std::get<0>(merit(best))) return false;
  const vnv::WorkDiagram& diagram = best.work->diagram;
  return object("case"_ = best.records->name, "id"_ = diagram.id, "title"_ = best.records->title(),
                "caption"_ = diagram.caption);
}

}  // namespace

Data overview_data(const std::vector<CaseRecords>& cases, const NightStatus& status) {
  std::vector<Standings> standings;
  List flows, others;
  for (const CaseRecords& records : cases) {
    const Standings& all = standings.emplace_back(standings_of(records));
    if (all.work)
      add_flow(flows, all, status);
    else
      others.push_back(other_data(all, status));
  }
  return object("work"_ = work_figure(standings), "how_many"_ = how_many(standings, status),
                "most_wrong"_ = most_wrong(standings, status), "flows"_ = if_any(flows), "others"_ = if_any(others));
}

}  // namespace touchstone::reports
