#include "reports/pages/index.hpp"

#include "reports/compare/standings.hpp"
#include "reports/figures/figures.hpp"
#include "reports/pages/order_matrix.hpp"
#include "reports/pages/verdicts.hpp"
#include "reports/pages/work_page.hpp"
#include "reports/text/notation.hpp"
#include "vnv/record/same_time.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <ranges>
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
  for (const auto& [error, item] : found | std::views::take(most)) items += item;
  if (items.empty()) return "";
  return fmt::format("<p class=\"quiet\">Wrong by {} % and more, as last accepted: {}{}</p>\n", far_off,
                     counted(std::ssize(found), "method"), found.size() > most ? ", the farthest:" : "") +
         html_list("declared", items);
}

/// How many methods are what, and what that means.
std::string legend(const std::vector<Standings>& standings, const NightStatus& status) {
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

// Records made in the same place stand in one line.
using Place = std::array<std::string, 4>;

HtmlRow place_row(const Place& place, const std::set<std::string>& times, long records) {
  const std::string until = times.size() > 1 ? " to " + escape(*times.rbegin()) : "";
  return {words_cell(escape(place[0])),
          words_cell(escape(place[1])),
          words_cell("<code>" + escape(place[2]) + "</code>"),
          words_cell(escape(place[3])),
          words_cell(escape(*times.begin()) + until),
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
                  {"revision", "compiler", "flags", "machine", "finished", "records"}};
  for (const auto& [place, made] : finished) table.rows.push_back(place_row(place, made.first, made.second));
  return to_html(table);
}

/// The colour of the whole night.
std::string kind_of_night(const Tally& sum, const NightStatus& status) {
  if (status.red_count() > 0) return "fails";
  return status.known.empty() ? word(sum.worst()) : "known";
}

/// What the list of known failures has to say of the count.
std::string known_words(const NightStatus& status) {
  std::string words;
  if (!status.known.empty()) words += fmt::format(" {} known to fail.", status.known.size());
  if (!status.unexpected_passes.empty())
    words += fmt::format(" {} known to fail, but passed.", status.unexpected_passes.size());
  return words;
}

std::string orders_link(const std::vector<CaseRecords>& cases) {
  if (std::ranges::none_of(cases, is_in_matrix)) return "";
  return "<p>How fast the errors of each method decrease in each flow: <a href=\"orders.html\">observed orders of "
         "convergence</a>.</p>\n";
}

std::string work_link(const std::vector<CaseRecords>& cases) {
  if (std::ranges::none_of(cases, is_priced)) return "";
  return "<p>What an error costs in each flow, and which method is cheapest: <a href=\"work.html\">error against run "
         "time</a>.</p>\n";
}

/// The first ten items of a list, and a fold with the others.
std::string folded(const std::string& list) {
  constexpr std::string_view end = "</li>\n";
  std::size_t at = 0;
  for (int shown = 0; shown < 10 && at != std::string::npos; ++shown)
    if (at = list.find(end, at); at != std::string::npos) at += end.size();
  if (at == std::string::npos || !list.substr(at).starts_with("<li>")) return list;
  const auto others = std::ranges::count(list.substr(at), '\n') - 1;
  const std::string head = list.substr(0, list.find('\n') + 1);
  return fmt::format("{}</ul>\n<details>\n<summary>{} more</summary>\n{}{}</details>\n", list.substr(0, at), others,
                     head, list.substr(at));
}

/// Red and amber, with ids and expiry dates; empty if nothing fails and nothing is known.
std::string status_html(const NightStatus& s) {
  std::string red, amber;
  if (!s.claims.missing.empty()) red += fmt::format("<li>{}</li>\n", escape(s.claims.missing));
  for (const auto& verdict : s.unknown) red += fmt::format("<li>{}</li>\n", typeset(verdict.sentence));
  for (const auto& row : s.unexpected_passes)
    red += fmt::format("<li>{}.{} {}: {}: unexpected pass of the known failure {}: remove it</li>\n",
                       escape(row.case_name), escape(row.method), escape(row.level), typeset(row.quantity),
                       escape(row.id));
  for (const auto& row : s.expired)
    red +=
        fmt::format("<li>The known failure {} expired on {}: mend it or review it</li>\n", escape(row.id), row.expires);
  for (std::size_t i = 0; i < s.known.size(); ++i)
    amber += fmt::format("<li>{} <small>known as {} until {}: {}</small></li>\n", typeset(s.known[i].sentence),
                         escape(s.of_known[i].id), s.of_known[i].expires, typeset(s.of_known[i].reason));
  const std::string note = s.claims.note.empty() ? "" : fmt::format("<p>{}</p>\n", escape(s.claims.note));
  return folded(html_list("fails", red)) + folded(html_list("known", amber)) + note;
}

constexpr const char* verdicts_link =
    "<p>Every claim with its value, its limit and who set that: <a href=\"verdicts.html\">verdicts</a>.</p>\n";

constexpr const char* trend_link =
    "<p>How the values developed from night to night, and what changed last: <a href=\"trend.html\">trend</a>.</p>\n";

std::string faults_link(const std::optional<FaultTrials>& faults) {
  if (!faults) return "";
  return fmt::format("<p>What the tests would miss: <a href=\"faults.html\">detection rate</a>. {}</p>\n",
                     faults->sentence());
}

}  // namespace

std::string index_page(const std::vector<CaseRecords>& cases, const NightStatus& status, bool has_trend,
                       const std::optional<FaultTrials>& faults) {
  const auto verdicts = verdicts_of(cases);
  const Tally sum = tally(verdicts);
  std::vector<Standings> standings;
  for (const CaseRecords& records : cases) standings.push_back(standings_of(records));
  const std::string body = fmt::format(
      "<main>\n<header>\n<h1>Touchstone</h1>\n<p class=\"sum {}\">{}{}</p>\n{}{}</header>\n"
      "<p>Particle methods for fluid flow, compared with exact solutions, experiments and published results.</p>\n"
      "{}{}{}{}"
      "<p class=\"files\">Tables for other programs: <a href=\"verdicts.csv\">verdicts</a> <a "
      "href=\"orders.csv\">orders</a> <a href=\"cost.csv\">cost</a></p>\n</main>\n",
      kind_of_night(sum, status), sentence(sum), known_words(status), status_html(status),
      folded(list_of(vnv::Outcome::inconclusive, verdicts)),
      "<div class=\"front\">\n" + work_figure(cases, standings) + "<div>\n" + legend(standings, status) +
          most_wrong(cases, standings, status) + "</div>\n</div>\n",
      tables_of_methods(cases, standings, status),
      verdicts_link + orders_link(cases) + work_link(cases) + (has_trend ? trend_link : "") + faults_link(faults),
      environment(cases));
  return html_page("Touchstone", "", body);
}

}  // namespace touchstone::reports
