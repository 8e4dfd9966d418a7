#include "reports/pages/pages.hpp"

#include "reports/pages/verdicts.hpp"
#include "reports/text/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace touchstone::reports {
namespace {

// Records made in the same place stand in one line.
using Origin = std::array<std::string, 4>;

List places(const std::vector<CaseRecords>& cases) {
  std::map<Origin, std::pair<std::set<std::string>, long>> finished;
  for (const auto& records : cases)
    for (const auto& r : records.records) {
      auto& [times, count] = finished[{r.revision, r.compiler, r.flags, r.machine}];
      times.insert(r.finished_at);
      ++count;
    }
  return each(finished, [](const auto& found) {
    const auto& [place, made] = found;
    const auto& [times, records] = made;
    return object("revision"_ = place[0], "compiler"_ = place[1], "flags"_ = place[2], "machine"_ = place[3],
                  "first"_ = *times.begin(), "last"_ = when(times.size() > 1, *times.rbegin()), "records"_ = records);
  });
}

/// The colour of the whole night.
std::string kind_of_night(const Tally& sum, const NightStatus& status) {
  if (status.red_count() > 0) return "fails";
  return status.known.empty() ? word(sum.worst()) : "known";
}

/// Adds a list of which all but the first ten items are folded.
void add_list(List& lists, const char* kind, const List& items) {
  const auto end_of_shown = items.begin() + std::min(std::ssize(items), std::ptrdiff_t{10});
  const List hidden(end_of_shown, items.end());
  const Data fold = object("count"_ = hidden.size(), "items"_ = hidden);
  if (!items.empty())
    lists.push_back(
        object("kind"_ = kind, "items"_ = List(items.begin(), end_of_shown), "fold"_ = when(!hidden.empty(), fold)));
}

/// A text that may have a note.
Data item(const std::string& text, const std::string& note = "") {
  return object("text"_ = text, "note"_ = if_any(note));
}

List red(const NightStatus& s) {
  List items;
  if (!s.claims.missing.empty()) items.push_back(item(s.claims.missing));
  for (const auto& verdict : s.unknown) items.push_back(item(verdict.sentence));
  for (const auto& row : s.unexpected_passes)
    items.push_back(item(fmt::format("{}.{} {}: {}: unexpected pass of the known failure {}: remove it", row.case_name,
                                     row.method, row.level, row.quantity, row.id)));
  for (const auto& row : s.expired)
    items.push_back(item(fmt::format("The known failure {} expired on {}: mend it or review it", row.id, row.expires)));
  return items;
}

/// With ids and expiry dates.
List amber(const NightStatus& s) {
  List items;
  for (std::size_t i = 0; i < s.known.size(); ++i)
    items.push_back(item(s.known[i].sentence, fmt::format("known as {} until {}: {}", s.of_known[i].id,
                                                          s.of_known[i].expires, s.of_known[i].reason)));
  return items;
}

}  // namespace

std::string html_of(const std::string& name, Data data) {
  data["title"] = all_pages().at(name).title;
  data["path"] = replaced(name, "_", " ");
  return page(name, data);
}

std::string index_page(const std::vector<CaseRecords>& cases, const NightStatus& status, const List& links) {
  const auto verdicts = verdicts_of(cases);
  const Tally sum = tally(verdicts);
  List failures, inconclusive;
  add_list(failures, "fails", red(status));
  add_list(failures, "known", amber(status));
  add_list(inconclusive, "inconclusive", sentences(vnv::Outcome::inconclusive, verdicts));
  return page("index",
              object("kind"_ = kind_of_night(sum, status), "sentence"_ = sentence(sum),
                     "known"_ = when(!status.known.empty(), status.known.size()),
                     "passed"_ = when(!status.unexpected_passes.empty(), status.unexpected_passes.size()),
                     "failures"_ = failures, "note"_ = if_any(status.claims.note), "inconclusive"_ = inconclusive,
                     "overview"_ = overview_data(cases, status), "pages"_ = links, "places"_ = places(cases)));
}

}  // namespace touchstone::reports
