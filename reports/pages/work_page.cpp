#include "reports/pages/work_page.hpp"

#include "reports/text/html.hpp"
#include "reports/text/notation.hpp"
#include "vnv/record/prices.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::reports {
namespace {

using vnv::Price;

/// "sph × 3.1": a method beside the cheapest.
std::string beside(const Price& cheapest, const Price& other) {
  if (other.method == cheapest.method) return escape(other.method);
  return fmt::format("{} {}", escape(other.method),
                     other.cpu > 0 ? "×\u202f" + printed(other.cpu / cheapest.cpu, 2) : "not reached");
}

/// What an error costs in a flow, its methods cheapest first.
HtmlRow cost_row(const std::string& flow, double target, const std::string& unit, const std::vector<Price>& methods) {
  const Price& best = methods.front();
  HtmlRow row{words_cell(flow), {valued(target, unit), "number"}};
  if (!(best.cpu > 0)) {
    row.push_back(words_cell(fmt::format("none; {} {}", escape(best.method), rounded(best.smallest, unit))));
    row.resize(row.size() + 3);
    return row;
  }
  row.push_back(HtmlCell("<b>" + escape(best.method) + "</b>"));
  row.push_back({printed(best.cpu, 2), "number"});
  row.push_back(HtmlCell(methods.size() > 1 && methods[1].cpu > 0 ? beside(best, methods[1]) : "–"));
  std::string printed_methods;
  for (const Price& p : methods)
    if (p.as_printed) printed_methods += (printed_methods.empty() ? "" : ", ") + beside(best, p);
  row.push_back(words_cell(printed_methods));
  return row;
}

std::string table_of_costs(const std::vector<CaseRecords>& cases) {
  HtmlTable table{"Cheapest method to a given error.",
                  "CPU seconds of one core, interpolated along the Pareto front of each method; × is the factor by "
                  "which other methods are more expensive: the next cheapest, and those that Sun et al. print. Last, "
                  "the largest of the errors that no method reaches, and the smallest that one reaches.",
                  {"flow", "error", "cheapest", "CPU [s]", "next", "as printed"}};
  for (const CaseRecords& records : cases)
    for (const vnv::WorkDiagram& diagram : each_once(records, &vnv::Record::diagrams)) {
      std::vector<Price> prices = vnv::prices_of(records.records);
      std::erase_if(prices, [&](const Price& p) { return p.quantity != diagram.quantity.heading(); });
      std::string flow = fmt::format("<a href=\"{}/index.html#{}\">{}</a><br><small>{}</small>", records.name,
                                     diagram.id, escape(records.title()), typeset(diagram.quantity.name));
      for (const double target : diagram.targets) {
        const std::vector<Price> methods = vnv::ranked(prices, target);
        table.rows.push_back(cost_row(std::exchange(flow, ""), target, diagram.quantity.unit, methods));
        if (!(methods.front().cpu > 0)) break;  // nor any smaller one
      }
    }
  return to_html(table);
}

std::string table_of_defaults(const std::vector<CaseRecords>& cases) {
  HtmlTable table{
      "Default methods.",
      fmt::format("By rule: the cheapest to the error by which the flow is ranked; of methods within a factor "
                  "of {:g}, the one that reaches the smallest error; where none gets there, the one with "
                  "the smallest error. <code>vnv explain CASE</code> says so, too.",
                  vnv::as_cheap),
      {"flow", "default", "reason"}};
  for (const CaseRecords& records : cases)
    if (const auto chosen = vnv::default_method(vnv::prices_of(records.records)))
      table.rows.push_back({words_cell(escape(records.title())), HtmlCell("<b>" + escape(chosen->method) + "</b>"),
                            words_cell(typeset(chosen->reason))});
  return to_html(table);
}

}  // namespace

bool is_priced(const CaseRecords& records) { return !vnv::prices_of(records.records).empty(); }

std::string work_page(const std::vector<CaseRecords>& cases) {
  std::vector<CaseRecords> priced;
  std::ranges::copy_if(cases, std::back_inserter(priced), is_priced);
  return html_page_beside_index(
      "Error against run time", "work", "",
      "<p>What an error costs in each flow. Equal particle numbers would be no fair measure: a step of "
      "one method costs many times that of another, and so does its error.</p>\n" +
          table_of_costs(priced) + table_of_defaults(priced) +
          "<p class=\"files\">Table for other programs: <a href=\"work.csv\">prices</a></p>\n");
}

std::string work_csv(const std::vector<CaseRecords>& cases) {
  std::vector<Price> all;
  std::string source;
  for (const CaseRecords& records : cases) {
    const std::vector<Price> prices = vnv::prices_of(records.records);
    all.insert(all.end(), prices.begin(), prices.end());
    if (!prices.empty() && source.empty())
      source = fmt::format("suite {} of this project at {}, {}", records.records.front().suite,
                           records.records.front().revision, records.records.front().machine);
  }
  return vnv::csv_of(all, source);
}

}  // namespace touchstone::reports
