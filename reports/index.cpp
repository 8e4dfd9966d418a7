#include "reports/index.hpp"

#include "reports/numbers.hpp"
#include "reports/order_matrix.hpp"
#include "reports/verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace touchstone::reports {
namespace {

std::vector<vnv::Verdict> all_verdicts(const std::vector<CaseRecords>& cases) {
  std::vector<vnv::Verdict> all;
  for (const auto& records : cases) {
    const auto some = verdicts_of(records);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::set<std::string> methods_of(const std::vector<CaseRecords>& cases) {
  std::set<std::string> methods;
  for (const auto& records : cases)
    for (const auto& record : records.records) methods.insert(record.method);
  return methods;
}

std::string counts(const Tally& t) {
  if (t.fails > 0) return fmt::format("{} of {} {}", t.fails, t.total(), t.fails == 1 ? "fails" : "fail");
  if (t.inconclusive > 0) return fmt::format("{} of {} inconclusive", t.inconclusive, t.total());
  return fmt::format("{} of {} {}", t.holds, t.total(), t.holds == 1 ? "holds" : "hold");
}

// Empty where the case has no such method.
HtmlCell matrix_cell(const CaseRecords& records, const std::string& method) {
  std::vector<vnv::Verdict> verdicts;
  bool is_run = false;
  for (const auto& record : records.records) {
    if (record.method != method) continue;
    is_run = true;
    verdicts.insert(verdicts.end(), record.verdicts.begin(), record.verdicts.end());
  }
  if (!is_run) return {};
  const Tally sum = tally(verdicts);
  if (sum.total() == 0) return {"no claim", "inconclusive"};
  const bool has_margin = sum.fails > 0 || !std::isnan(sum.worst_margin);
  return {fmt::format("<a href=\"{}/index.html\">{}</a>{}", records.name, counts(sum),
                      has_margin ? "<br>" + margin_bar(sum.worst_margin) : ""),
          word(sum.worst())};
}

std::string matrix(const std::vector<CaseRecords>& cases) {
  HtmlTable table{"Cases and methods.",
                  "With each, the smallest margin of its claims: the share of a limit that is left.",
                  {{"case"}},
                  {}};
  const auto methods = methods_of(cases);
  for (const auto& method : methods) table.columns.push_back({escape(method)});
  for (const auto& records : cases) {
    std::vector<HtmlCell> row{
        {fmt::format("<a href=\"{}/index.html\">{}</a>", records.name, escape(records.title())), "words"}};
    for (const auto& method : methods) row.push_back(matrix_cell(records, method));
    table.rows.push_back(std::move(row));
  }
  return to_html(table);
}

// Records made in the same place share a line.
using Place = std::array<std::string, 4>;

std::vector<HtmlCell> place_row(const Place& place, const std::set<std::string>& times, long records) {
  const std::string until = times.size() > 1 ? " to " + escape(*times.rbegin()) : "";
  return {{escape(place[0]), "words"},
          {escape(place[1]), "words"},
          {"<code>" + escape(place[2]) + "</code>", "words"},
          {escape(place[3]), "words"},
          {escape(*times.begin()) + until, "words"},
          number_cell(records)};
}

std::string environment(const std::vector<CaseRecords>& cases) {
  std::map<Place, std::pair<std::set<std::string>, long>> finished;
  for (const auto& records : cases)
    for (const auto& r : records.records) {
      auto& [times, count] = finished[{r.revision, r.compiler, r.flags, r.machine}];
      times.insert(r.finished_at);
      ++count;
    }
  HtmlTable table{"Environment.",
                  "Where and from what the records were made.",
                  {{"revision"}, {"compiler"}, {"flags"}, {"machine"}, {"finished"}, {"records", "number"}},
                  {}};
  for (const auto& [place, made] : finished) table.rows.push_back(place_row(place, made.first, made.second));
  return to_html(table);
}

std::string orders_link(const std::vector<CaseRecords>& cases) {
  if (std::ranges::none_of(cases, is_in_matrix)) return "";
  return "<p>How fast the errors of each method shrink in each flow: <a href=\"orders.html\">orders of "
         "convergence</a>.</p>\n";
}

}  // namespace

std::string index_page(const std::vector<CaseRecords>& cases) {
  const auto verdicts = all_verdicts(cases);
  const Tally sum = tally(verdicts);
  const std::string body = fmt::format(
      "<main>\n<header>\n<h1>Touchstone</h1>\n<p class=\"sum {}\">{}</p>\n{}</header>\n"
      "<p>Each claim says how far a solver may stand from an exact solution, an experiment, a published result or its "
      "own "
      "earlier answer, and who set that limit. A number that is not one never holds, and what cannot be told is called "
      "inconclusive, not passed.</p>\n{}{}{}"
      "<p class=\"files\">Tables for other programs: <a href=\"verdicts.csv\">verdicts</a> <a "
      "href=\"orders.csv\">orders</a> <a href=\"cost.csv\">cost</a></p>\n</main>\n",
      word(sum.worst()), sentence(sum), complaints(verdicts), matrix(cases), orders_link(cases), environment(cases));
  return html_page("Touchstone", "", body);
}

}  // namespace touchstone::reports
