#include "reports/pages/index.hpp"

#include "reports/pages/front.hpp"
#include "reports/pages/order_matrix.hpp"
#include "reports/pages/verdicts.hpp"
#include "reports/pages/work_page.hpp"
#include "reports/text/notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace touchstone::reports {
namespace {

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
  const std::string body = fmt::format(
      "<main>\n<header>\n<h1>Touchstone</h1>\n<p class=\"sum {}\">{}{}</p>\n{}{}</header>\n"
      "<p>Particle methods for fluid flow, compared with exact solutions, experiments and published results.</p>\n"
      "{}{}{}"
      "<p class=\"files\">Tables for other programs: <a href=\"verdicts.csv\">verdicts</a> <a "
      "href=\"orders.csv\">orders</a> <a href=\"cost.csv\">cost</a></p>\n</main>\n",
      kind_of_night(sum, status), sentence(sum), known_words(status), status_html(status),
      folded(list_of(vnv::Outcome::inconclusive, verdicts)), front_html(cases, status),
      verdicts_link + orders_link(cases) + work_link(cases) + (has_trend ? trend_link : "") + faults_link(faults),
      environment(cases));
  return html_page("Touchstone", "", body);
}

}  // namespace touchstone::reports
