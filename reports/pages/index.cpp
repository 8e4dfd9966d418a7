#include "reports/pages/index.hpp"

#include "reports/pages/order_matrix.hpp"
#include "reports/pages/verdicts.hpp"
#include "reports/pages/work_page.hpp"
#include "reports/text/notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace touchstone::reports {
namespace {

std::string counts(const Tally& t) {
  if (t.fails > 0) return fmt::format("{} of {} {}", t.fails, t.total(), t.fails == 1 ? "fails" : "fail");
  if (t.inconclusive > 0) return fmt::format("{} of {} inconclusive", t.inconclusive, t.total());
  return fmt::format("{} of {} {}", t.holds, t.total(), t.holds == 1 ? "holds" : "hold");
}

// A method of a case and how many of its claims hold, "mpm 34/34".
std::string method_entry(const vnv::Record& record) {
  const Tally sum = tally(record.verdicts);
  return fmt::format("<span>{} <small class=\"{}\">{}/{}</small></span> ", escape(record.method), word(sum.worst()),
                     sum.holds, sum.total());
}

/// Whether all that fails in a case is known to.
bool is_excused(const Tally& sum, const std::string& name, const NightStatus& status) {
  const auto is_its = [&](const vnv::Verdict& v) { return v.case_name == name; };
  return sum.fails > 0 && std::ranges::none_of(status.unknown, is_its);
}

HtmlCell counts_cell(const Tally& sum, const std::string& name, const NightStatus& status) {
  if (sum.total() == 0) return {"no claim", word(sum.worst())};
  if (is_excused(sum, name, status)) return {counts(sum) + ", known", "known"};
  return {counts(sum), word(sum.worst())};
}

std::string table_of_cases(const std::vector<CaseRecords>& cases, const NightStatus& status) {
  HtmlTable table{"Cases.",
                  "The smallest margin is the fraction of its limit that is left to the claim closest to it; beside "
                  "each method, how many of its claims hold.",
                  {"case", "claims", "smallest margin", "methods"}};
  for (const auto& records : cases) {
    const Tally sum = tally(verdicts_of(records));
    std::string methods;
    for (const auto& record : records.records) methods += method_entry(record);
    const bool has_margin = sum.fails > 0 || !std::isnan(sum.worst_margin);
    table.rows.push_back(
        {words_cell(fmt::format("<a href=\"{}/index.html\">{}</a>", records.name, escape(records.title()))),
         counts_cell(sum, records.name, status), has_margin ? margin_bar(sum.worst_margin) : "",
         words_cell("<div class=\"methods\">" + methods + "</div>")});
  }
  return to_html(table);
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
  return html_list("fails", red) + html_list("known", amber) + note;
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
  const std::string body = fmt::format(
      "<main>\n<header>\n<h1>Touchstone</h1>\n<p class=\"sum {}\">{}{}</p>\n{}{}</header>\n"
      "<p>Verification and validation of particle methods for fluid flow. Each claim says how far a solver may be from an "
      "exact solution, an experiment, a published result or its own earlier answer, and who set that limit. A value that is "
      "not a number never holds, and what cannot be decided is called inconclusive, not passed.</p>\n{}{}{}"
      "<p class=\"files\">Tables for other programs: <a href=\"verdicts.csv\">verdicts</a> <a "
      "href=\"orders.csv\">orders</a> <a href=\"cost.csv\">cost</a></p>\n</main>\n",
      kind_of_night(sum, status), sentence(sum), known_words(status), status_html(status),
      list_of(vnv::Outcome::inconclusive, verdicts), table_of_cases(cases, status),
      verdicts_link + orders_link(cases) + work_link(cases) + (has_trend ? trend_link : "") + faults_link(faults),
      environment(cases));
  return html_page("Touchstone", "", body);
}

}  // namespace touchstone::reports
