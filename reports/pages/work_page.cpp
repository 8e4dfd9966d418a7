#include "reports/pages/pages.hpp"

#include "vnv/record/prices.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::reports::pages {
namespace {

using vnv::Price;

/// "sph × 3.1": a method beside the cheapest.
std::string beside(const Price& cheapest, const Price& other) {
  if (other.method == cheapest.method) return other.method;
  return fmt::format("{} {}", other.method,
                     other.cpu > 0 ? "×\u202f" + printed(other.cpu / cheapest.cpu, 2) : "not reached");
}

std::string as_printed(const std::vector<Price>& methods) {
  std::string text;
  for (const Price& p : methods)
    if (p.as_printed) text += (text.empty() ? "" : ", ") + beside(methods.front(), p);
  return text;
}

/// What an error costs in a flow, its methods cheapest first.
Data cost_data(double target, const std::string& unit, const std::vector<Price>& methods) {
  const Price& best = methods.front();
  const bool has_next = methods.size() > 1 && methods[1].cpu > 0;
  return object("error"_ = valued(target, unit), "method"_ = best.method, "is_reached"_ = best.cpu > 0,
                "smallest"_ = rounded(best.smallest, unit), "cpu"_ = printed(best.cpu, 2),
                "next"_ = has_next ? beside(best, methods[1]) : "–", "as_printed"_ = as_printed(methods));
}

List costs(const std::vector<CaseRecords>& cases) {
  List items;
  for (const CaseRecords& records : cases)
    for (const vnv::WorkDiagram& diagram : each_once(records, &vnv::Record::diagrams)) {
      std::vector<Price> prices = vnv::prices_of(records.records);
      std::erase_if(prices, [&](const Price& p) { return p.quantity != diagram.quantity.heading(); });
      Data flow = object("case"_ = records.name, "id"_ = diagram.id, "title"_ = records.title(),
                         "quantity"_ = diagram.quantity.name);
      for (const double target : diagram.targets) {
        const std::vector<Price> methods = vnv::ranked(prices, target);
        items.push_back(cost_data(target, diagram.quantity.unit, methods));
        items.back()["flow"] = std::exchange(flow, Data(false));  // stands in the first of its rows
        if (!(methods.front().cpu > 0)) break;                    // nor any smaller one
      }
    }
  return items;
}

List defaults(const std::vector<CaseRecords>& cases) {
  List items;
  for (const CaseRecords& records : cases)
    if (const auto chosen = vnv::default_method(vnv::prices_of(records.records)))
      items.push_back(object("title"_ = records.title(), "method"_ = chosen->method, "reason"_ = chosen->reason));
  return items;
}

/// For programs, and for data/work.csv, by which `vnv explain` names the default method of a flow.
std::string table(const std::vector<CaseRecords>& priced) {
  std::vector<Price> all;
  for (const CaseRecords& records : priced) {
    const std::vector<Price> prices = vnv::prices_of(records.records);
    all.insert(all.end(), prices.begin(), prices.end());
  }
  const vnv::Record& first = priced.front().records.front();
  return vnv::csv_of(all,
                     fmt::format("suite {} of this project at {}, {}", first.suite, first.revision, first.machine));
}

}  // namespace

Page work() {
  return {.title = "Error against run time",
          .sentence = "What an error costs in each flow, and which method is cheapest",
          .content = [](const Findings& all) -> Content {
            std::vector<CaseRecords> priced;
            std::ranges::copy_if(all.cases, std::back_inserter(priced),
                                 [](const CaseRecords& records) { return !vnv::prices_of(records.records).empty(); });
            if (priced.empty()) return {};
            return {object("costs"_ = if_any(costs(priced)), "as_cheap"_ = fmt::format("{:g}", vnv::as_cheap),
                           "defaults"_ = if_any(defaults(priced))),
                    {{"work.csv", table(priced)}}};
          }};
}

}  // namespace touchstone::reports::pages
