#include "reports/pages/front.hpp"

#include "reports/compare/standings.hpp"
#include "reports/figures/figures.hpp"
#include "reports/text/html.hpp"
#include "reports/text/notation.hpp"
#include "vnv/record/same_time.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace touchstone::reports {
namespace {

std::string counts(const Tally& t) {
  if (t.fails > 0) return fmt::format("{} of {} {}", t.fails, t.total(), t.fails == 1 ? "fails" : "fail");
  return fmt::format("{} of {} inconclusive", t.inconclusive, t.total());
}

/// What keeps records of a case, which `is_its` knows by their claims, from being good; nothing where all claims hold.
std::optional<HtmlCell> flaw(const Tally& sum, const NightStatus& status, const auto& is_its) {
  if (sum.total() == 0) return HtmlCell("no claim", word(sum.worst()));
  if (sum.fails > 0 && std::ranges::none_of(status.unknown, is_its)) return HtmlCell(counts(sum) + ", known", "known");
  if (sum.worst() != vnv::Outcome::holds) return HtmlCell(counts(sum), word(sum.worst()));
  return std::nullopt;
}

/// What a method is called in a flow, and the class of its colour.
HtmlCell stands(const Standing& one, const NightStatus& status) {
  const auto is_its = [&](const vnv::Verdict& v) {
    return v.case_name == one.record->case_name && v.method == one.record->method;
  };
  if (auto found = flaw(tally(one.record->verdicts), status, is_its)) return *found;
  if (one.right_by.empty()) return {"as last accepted", "accepted"};
  return {one.converges() ? "converges" : "agrees", "holds"};
}

constexpr double far_off = 10;  // %

bool is_far_off(const vnv::Value& error) { return error.quantity.unit == "%" && std::abs(error.value) >= far_off; }

/// "as last accepted, wrong by 51 %", with the time where it is not that of the flow; "converges theory".
HtmlCell stands_at_length(const Standing& one, double time, const NightStatus& status) {
  HtmlCell cell = stands(one, status);
  if (cell.kind == "accepted" && one.at_end) {
    const std::string wrong = "wrong by " + rounded(std::abs(one.at_end->value), one.at_end->quantity.unit);
    cell.html += ", " + (is_far_off(*one.at_end) ? "<b>" + wrong + "</b>" : wrong);
    if (!vnv::same_time(one.at_end->time, time))
      cell.html += fmt::format(" <small>at {}\u202fs</small>", printed(one.at_end->time));
  }
  if (cell.kind == "holds") {
    std::set<std::string> authors;
    for (const vnv::Verdict& v : one.right_by) authors.insert(v.author.substr(0, v.author.find(':')));
    cell.html += fmt::format(" <small>{}</small>", fmt::join(authors, ", "));
  }
  return cell;
}

HtmlCell best_if(bool is_best, const std::string& html) {
  return is_best ? HtmlCell("<b>" + html + "</b>", "number") : HtmlCell(html, "number");
}

HtmlCell order_cell(const Standing& one) {
  if (!one.order || std::isnan(one.order->order)) return {"–", "number none"};
  return {with_interval(one.order->order, one.order->half_width), "number " + word(one.order->trend)};
}

/// A picture of a case, its name, and beside them what is said of it.
HtmlCell case_cell(const CaseRecords& records, const std::string& about = "", std::size_t rows = 1) {
  const std::string link = fmt::format("<a href=\"{}/index.html\">", records.name), image = first_image(records);
  const std::string thumb =
      image.empty() ? ""
                    : fmt::format("{}<img src=\"{}/{}\" alt=\"\" loading=\"lazy\"></a>", link, records.name, image);
  return {fmt::format("{}<div>{}{}</a>{}</div>", thumb, link, escape(records.title()), about), "flow", rows};
}

/// "2 / 0 / 16": claims by theory, literature and baselines.
HtmlCell authors_cell(const Tally& sum) {
  return {fmt::format("{}\u2009/\u2009{}\u2009/\u2009{}", sum.theory, sum.literature, sum.baseline), "number"};
}

/// Rows of a flow in which an error is measured, a method each, the first with the flow.
std::vector<HtmlRow> flow_rows(const CaseRecords& records, const Standings& all, const NightStatus& status) {
  const vnv::WorkDiagram& diagram = all.work->diagram;
  std::vector<HtmlRow> rows;
  for (const Standing& one : all.methods) {
    const Tally sum = tally(one.record->verdicts);
    HtmlRow row{
        escape(one.record->method),
        best_if(one.is_most_accurate, std::isnan(one.error) ? "–" : rounded(one.error, diagram.quantity.unit)),
        order_cell(one),
        best_if(one.is_cheapest,
                !one.cost.is_reached() ? "–" : (one.cost.at_most ? "≤\u202f" : "") + rounded(one.cost.cpu, "s")),
        stands_at_length(one, all.work->time, status),
        authors_cell(sum)};
    row[4].kind += " words";
    if (rows.empty()) {
      const std::string target =
          std::isnan(diagram.ranked_by)
              ? ""
              : fmt::format("; CPU time to {}", valued(diagram.ranked_by, diagram.quantity.unit));
      row.insert(row.begin(), case_cell(records,
                                        fmt::format("<br><small>{}, {}\u202fs{}</small>",
                                                    typeset(diagram.quantity.name), printed(all.work->time), target),
                                        all.methods.size()));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// A case in which no error is measured.
HtmlRow other_row(const CaseRecords& records, const Standings& all, const NightStatus& status) {
  std::string methods;
  for (const Standing& one : all.methods)
    methods += fmt::format("<span class=\"{}\">{}</span> ", stands(one, status).kind, escape(one.record->method));
  const auto right = std::ranges::count_if(all.methods, [](const Standing& one) { return !one.right_by.empty(); });
  const Tally sum = tally(verdicts_of(records));
  const auto found = flaw(sum, status, [&](const vnv::Verdict& v) { return v.case_name == records.name; });
  return {case_cell(records),
          found        ? *found
          : right == 0 ? HtmlCell("as last accepted", "accepted")
                       : HtmlCell(fmt::format("{} of {} agree", right, all.methods.size()), "holds"),
          words_cell("<div class=\"methods\">" + methods + "</div>"), authors_cell(sum)};
}

std::string tables_of_methods(const std::vector<CaseRecords>& cases, const std::vector<Standings>& standings,
                              const NightStatus& status) {
  HtmlTable flows{
      "Which method for which error.",
      "The smallest error of each method, its observed order with its 95\u202f% interval, and the CPU time of "
      "one core to the error that stands with the flow; the best of a flow is bold. Claims by theory / by "
      "literature / that values are as last accepted.",
      {"flow", "method", "error", "order", "CPU time", "verdict", "claims"},
      {},
      "flows"};
  HtmlTable others{"Other claims.",
                   "Stability, invariance, cost: where no error is measured.",
                   {"case", "verdict", "methods", "claims"},
                   {},
                   "flows"};
  for (std::size_t c = 0; c < cases.size(); ++c)
    if (standings[c].work)
      std::ranges::move(flow_rows(cases[c], standings[c], status), std::back_inserter(flows.rows));
    else
      others.rows.push_back(other_row(cases[c], standings[c], status));
  return to_html(flows) + to_html(others);
}

/// The accepted methods that are farthest off, among errors in per cent.
std::string most_wrong(const std::vector<CaseRecords>& cases, const std::vector<Standings>& standings,
                       const NightStatus& status) {
  constexpr std::size_t most = 8;
  std::vector<std::pair<double, std::string>> found;
  for (std::size_t c = 0; c < cases.size(); ++c)
    for (const Standing& one : standings[c].methods)
      if (one.at_end && is_far_off(*one.at_end) && stands(one, status).kind == "accepted")
        found.emplace_back(
            std::abs(one.at_end->value),
            fmt::format("<li>{} {} in <a href=\"{}/index.html\">{}</a></li>\n", escape(one.record->method),
                        rounded(std::abs(one.at_end->value), "%"), cases[c].name, escape(cases[c].title())));
  std::ranges::stable_sort(found, std::greater(), &std::pair<double, std::string>::first);
  std::string items;
  for (std::size_t m = 0; m < found.size() && m < most; ++m) items += found[m].second;
  if (items.empty()) return "";
  return fmt::format("<p class=\"quiet\">Wrong by {} % and more, as last accepted: {}{}</p>\n", far_off,
                     counted(std::ssize(found), "method"), found.size() > most ? ", the farthest:" : "") +
         html_list("declared", items);
}

/// How many methods are what, and what that means.
std::string how_many(const std::vector<Standings>& standings, const NightStatus& status) {
  std::map<std::string, long> counts;
  for (const Standings& all : standings)
    for (const Standing& one : all.methods) ++counts[stands(one, status).kind];
  std::string html;
  for (const auto& [kind, words, meaning] :
       {std::tuple("holds", "converge or agree",
                   "claims of theory or literature hold, of the error or its order where an error is measured"),
        {"accepted", "as last accepted", "nobody else says that they are right: as wrong as before"},
        {"inconclusive", "inconclusive", "cannot be decided, which is no pass"},
        {"known", "known to fail", "listed with a reason, until a date"},
        {"fails", "fail", "some claim does not hold"}})
    if (const long count = counts[kind]; count > 0 || std::string_view(kind) == "fails")
      html += fmt::format("<li class=\"{}\"><b>{} {}</b> {}</li>\n", count > 0 ? kind : "none", printed(count), words,
                          meaning);
  return fmt::format("<p class=\"quiet\">Methods, each in each flow:</p>\n<ul class=\"legend\">\n{}</ul>\n", html);
}

/// Error against run time in one flow, as on its own page: that of the picture in README, or else the one with most
/// runs.
std::string work_figure(const std::vector<CaseRecords>& cases, const std::vector<Standings>& standings) {
  const auto merit = [&](std::size_t c) {
    const bool is_drawn = standings[c].work && !standings[c].work->diagram.id.empty();
    return std::tuple(is_drawn, cases[c].name.starts_with("poiseuille"),
                      is_drawn ? standings[c].work->points.size() : 0);
  };
  std::vector<std::size_t> all(cases.size());
  std::iota(all.begin(), all.end(), 0);
  const std::size_t best = *std::ranges::max_element(all, {}, merit);
  if (!std::get<0>(merit(best))) return "";
  const vnv::WorkDiagram& diagram = standings[best].work->diagram;
  return fmt::format(
      "<figure>\n<a href=\"{0}/index.html#{1}\"><img src=\"{0}/{1}.svg\" alt=\"{2}: error against run time\"></a>\n"
      "<figcaption><b>{2}.</b> {3}</figcaption>\n</figure>\n",
      cases[best].name, diagram.id, escape(cases[best].title()), typeset(diagram.caption));
}

}  // namespace

std::string front_html(const std::vector<CaseRecords>& cases, const NightStatus& status) {
  std::vector<Standings> standings;
  for (const CaseRecords& records : cases) standings.push_back(standings_of(records));
  return fmt::format("<div class=\"front\">\n{}<div>\n{}{}</div>\n</div>\n{}", work_figure(cases, standings),
                     how_many(standings, status), most_wrong(cases, standings, status),
                     tables_of_methods(cases, standings, status));
}

}  // namespace touchstone::reports
