#include "reports/pages/pages.hpp"

#include "reports/compare/work_precision.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace touchstone::reports::pages {
namespace {

/// A column.
struct Column {
  const CaseRecords* records;
  OrderComparison comparison;

  std::string figure_link() const { return fmt::format("{}/index.html#{}", records->name, comparison.id()); }
  std::string unit() const { return vnv::with_heading(comparison.subject.quantity).unit; }
};

std::vector<Column> flows_with(Field field, const std::vector<CaseRecords>& cases) {
  std::vector<Column> flows;
  for (const auto& records : cases)
    if (auto comparison = principal_comparison(records, field)) flows.push_back({&records, std::move(*comparison)});
  return flows;
}

std::set<std::string> methods_in(const std::vector<Column>& flows) {
  std::set<std::string> methods;
  for (const auto& flow : flows)
    for (const auto& record : flow.records->records) methods.insert(record.method);
  return methods;
}

/// Why a cell has no order, as the notes below the table say.
struct Reason {
  char letter;
  const char* words;
};
constexpr std::array reasons{Reason{'a', "not run in this flow"},
                             Reason{'b', "this quantity was not measured at this time"},
                             Reason{'c', "measured at fewer than two spacings of a ladder"}};

const Reason& reason_for_none(const Column& flow, const std::string& method) {
  const auto& all = flow.records->records;
  const auto record = std::ranges::find(all, method, &vnv::Record::method);
  if (record == all.end()) return reasons[0];
  const bool is_measured = std::ranges::any_of(
      record->values, [&](const vnv::Value& e) { return flow.comparison.subject.is(e.quantity.heading(), e.time); });
  return is_measured ? reasons[2] : reasons[1];
}

/// What is shown to a pointer that rests on an order.
std::string details(const vnv::ObservedOrder& o) {
  return fmt::format("{} spacings from {} to {} mm, {}{}", o.spacings.size(), plain(1e3 * o.spacings.front()),
                     plain(1e3 * o.spacings.back()), o.ladder, o.asymptotic ? "; asymptotic" : "");
}

/// The orders of a method in a flow, with the trend of the first, or why there is none.
Data cell(const Column& flow, const std::string& method, std::set<char>& notes) {
  const std::vector<OrderLine> lines = flow.comparison.of_method(method);
  if (lines.empty()) {
    const Reason& why = reason_for_none(flow, method);
    notes.insert(why.letter);
    return object("none"_ = object("words"_ = why.words, "letter"_ = std::string(1, why.letter)), "kind"_ = false);
  }
  const auto order = [&](const OrderLine& line) {
    const vnv::ObservedOrder& o = line.order;
    return object("is_next"_ = &line != &lines.front(), "details"_ = details(o),
                  "order"_ = std::isnan(o.order) ? "no order" : with_interval(o.order, o.half_width),
                  "trend"_ = sign_and_word(o.trend), "of_two"_ = o.spacings.size() == 2,
                  "floor"_ = when(!std::isnan(o.floor), rounded(o.floor, flow.unit())),
                  "ladder"_ = when(lines.size() > 1, o.ladder));
  };
  return object("none"_ = false, "kind"_ = word(lines.front().order.trend), "link"_ = flow.figure_link(),
                "lines"_ = each(lines, order));
}

Data cheapest_data(const Column& flow) {
  const auto found = cheapest(*flow.records, flow.comparison.subject);
  if (!found) return false;
  return object("method"_ = found->best.method, "cost"_ = rounded(found->best.time),
                "error"_ = rounded(found->error, flow.unit()), "machine"_ = if_any(found->machine),
                "next"_ = found->next.method, "next_cost"_ = rounded(found->next.time));
}

Data heading(const Column& flow) {
  return object("link"_ = flow.figure_link(), "title"_ = flow.records->title(),
                "quantity"_ = vnv::with_heading(flow.comparison.subject.quantity).name,
                "time"_ = valued(flow.comparison.subject.time, "s"));
}

/// A matrix of the orders of a field in all flows that have them.
void add_matrix(List& matrices, const char* title, Field field, const std::vector<CaseRecords>& cases) {
  const std::vector<Column> flows = flows_with(field, cases);
  if (flows.empty()) return;
  std::set<char> used;
  const auto row = [&](const std::string& method) {
    return object("method"_ = method,
                  "cells"_ = each(flows, [&](const Column& flow) { return cell(flow, method, used); }));
  };
  const List rows = each(methods_in(flows), row);
  List notes;
  for (const auto& [letter, words] : reasons)
    if (used.contains(letter)) notes.push_back(object("letter"_ = std::string(1, letter), "words"_ = words));
  matrices.push_back(object("title"_ = title, "flows"_ = each(flows, heading), "rows"_ = rows,
                            "cheapest"_ = each(flows, cheapest_data), "notes"_ = if_any(notes)));
}

}  // namespace

Page orders() {
  return {.title = "Observed orders of convergence",
          .sentence = "How fast the errors of each method decrease in each flow",
          .content = [](const Findings& all) -> Content {
            List matrices;
            add_matrix(matrices, "Velocity", Field::velocity, all.cases);
            add_matrix(matrices, "Pressure", Field::pressure, all.cases);
            return {when(!matrices.empty(), object("matrices"_ = matrices))};
          }};
}

}  // namespace touchstone::reports::pages
