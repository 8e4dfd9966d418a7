#include "reports/read/known_failures.hpp"

#include "reports/read/rows.hpp"
#include "reports/text/html.hpp"
#include "reports/text/numbers.hpp"
#include "vnv/record/former.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <optional>

namespace touchstone::reports {
namespace {

const std::vector<std::string> columns{"id", "case", "method", "level", "quantity", "since", "expires", "reason"};

/// "2026-11-22"; nothing for a day that no calendar has.
std::optional<std::chrono::sys_days> day_of(const std::string& date) {
  int year = 0;
  unsigned month = 0, day = 0;
  const auto number = [&](std::size_t from, std::size_t length, auto& value) {
    const char *first = date.data() + from, *last = first + length;
    return std::from_chars(first, last, value).ptr == last;
  };
  if (date.size() != 10 || date[4] != '-' || date[7] != '-') return std::nullopt;
  if (!number(0, 4, year) || !number(5, 2, month) || !number(8, 2, day)) return std::nullopt;
  const std::chrono::year_month_day whole{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
  return whole.ok() ? std::optional(std::chrono::sys_days(whole)) : std::nullopt;
}

void require_dates(const KnownFailure& known, const Line& line) {
  const auto since = day_of(known.since), expires = day_of(known.expires);
  if (!since) line.refuse(fmt::format("since '{}', expected a date such as 2026-11-22", known.since));
  if (!expires) line.refuse(fmt::format("expires '{}', expected a date such as 2026-11-22", known.expires));
  const auto days = (*expires - *since).count();
  if (days < 0 || days > longest_known)
    line.refuse(fmt::format("expires {} days after {}, expected 0 to {}: what is not fixed by then is reviewed", days,
                            known.since, longest_known));
}

KnownFailure failure_on(const Row& row) {
  const auto& [line, fields] = row;
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (fields[i].find_first_not_of(' ') == std::string::npos && columns[i] != "level")
      line.refuse(fmt::format("no {}, expected one", columns[i]));
  KnownFailure known{fields[0], fields[1], fields[2], fields[3], vnv::current_name(fields[4]),
                     fields[5], fields[6], fields[7]};
  require_dates(known, line);
  return known;
}

bool name_the_same(const KnownFailure& a, const KnownFailure& b) {
  return a.case_name == b.case_name && a.method == b.method && a.level == b.level && a.quantity == b.quantity;
}

void add(std::vector<KnownFailure>& all, KnownFailure known, const Line& line) {
  for (const KnownFailure& other : all) {
    if (other.id == known.id) line.refuse(fmt::format("id '{}' again, expected it once", known.id));
    if (name_the_same(other, known)) line.refuse(fmt::format("the same claim as '{}', expected it once", other.id));
  }
  all.push_back(std::move(known));
}

std::string list(const char* kind, const std::string& items) {
  return items.empty() ? "" : fmt::format("<ul class=\"{}\">\n{}</ul>\n", kind, items);
}

}  // namespace

bool KnownFailure::covers(const vnv::Verdict& v) const {
  return case_name == v.case_name && method == v.method && level == v.level &&
         quantity == with_unit(v.quantity, v.unit);
}

std::vector<KnownFailure> read_known_failures(const std::filesystem::path& file) {
  std::vector<KnownFailure> all;
  for (const Row& row : read_rows(file, columns).rows) add(all, failure_on(row), row.line);
  return all;
}

std::string Standing::sentence() const {
  return fmt::format("{} red: {} unknown or expired {}, {} unexpected {}; {} known", reds(), unknown.size(),
                     unknown.size() == 1 ? "failure" : "failures", unexpected_passes.size(),
                     unexpected_passes.size() == 1 ? "pass" : "passes", known.size());
}

Standing standing(const std::vector<CaseRecords>& cases, const std::vector<KnownFailure>& known,
                  const std::string& today) {
  Standing result;
  std::vector<long> judged(known.size()), failed(known.size());
  for (const auto& records : cases)
    for (const auto& verdict : verdicts_of(records)) {
      const auto row = std::ranges::find_if(known, [&](const KnownFailure& k) { return k.covers(verdict); });
      const bool fails = verdict.outcome == vnv::Outcome::fails;
      const bool excused = row != known.end() && !row->is_expired(today);
      if (row != known.end()) {
        ++judged[row - known.begin()];
        failed[row - known.begin()] += fails;
      }
      if (!fails) continue;
      (excused ? result.known : result.unknown).push_back(verdict);
      if (excused) result.of_known.push_back(*row);
    }
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (known[i].is_expired(today) && failed[i] > 0) result.expired.push_back(known[i]);
    if (judged[i] > 0 && failed[i] == 0) result.unexpected_passes.push_back(known[i]);
  }
  return result;
}

std::string standing_html(const Standing& s) {
  std::string red, amber;
  for (const auto& verdict : s.unknown) red += fmt::format("<li>{}</li>\n", typeset(verdict.sentence));
  for (const auto& row : s.unexpected_passes)
    red += fmt::format("<li>{}.{} {}: {}: unexpected pass of the known failure {}: remove it</li>\n",
                       escape(row.case_name), escape(row.method), escape(row.level), typeset(row.quantity),
                       escape(row.id));
  for (const auto& row : s.expired)
    red += fmt::format("<li>The known failure {} expired on {}: fix or review it</li>\n", escape(row.id), row.expires);
  for (std::size_t i = 0; i < s.known.size(); ++i)
    amber += fmt::format("<li>{} <small>known as {} until {}: {}</small></li>\n", typeset(s.known[i].sentence),
                         escape(s.of_known[i].id), s.of_known[i].expires, typeset(s.of_known[i].reason));
  return list("fails", red) + list("known", amber);
}

}  // namespace touchstone::reports
