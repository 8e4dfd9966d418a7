#include "reports/read/known_failures.hpp"

#include "reports/text/notation.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/record/former.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <iomanip>
#include <optional>
#include <sstream>

namespace touchstone::reports {
namespace {

const std::vector<std::string> failure_columns{"id",       "case",  "method",  "level",
                                               "quantity", "since", "expires", "reason"};

/// "2026-11-22"; nothing for a day that no calendar has.
std::optional<std::chrono::sys_days> day_of(const std::string& date) {
  std::tm read{};
  std::istringstream text(date);
  text >> std::get_time(&read, "%Y-%m-%d");
  const std::chrono::year_month_day day{std::chrono::year(read.tm_year + 1900), std::chrono::month(read.tm_mon + 1),
                                        std::chrono::day(read.tm_mday)};
  const bool is_whole = date.size() == 10 && text.peek() == EOF;
  return day.ok() && is_whole ? std::optional(std::chrono::sys_days(day)) : std::nullopt;
}

KnownFailure failure_on(const vnv::Sheet& sheet, const vnv::Sheet::Row& row) {
  const auto refuse = [&](const std::string& what) { throw vnv::BadData(sheet.file, row.line, what); };
  const auto& c = row.cells;
  for (std::size_t i = 0; i < c.size(); ++i)
    if (c[i].empty() && failure_columns[i] != "level") refuse(fmt::format("no {}, expected one", failure_columns[i]));
  const auto since = day_of(c[5]), expires = day_of(c[6]);
  if (!since) refuse(fmt::format("since '{}', expected a date such as 2026-11-22", c[5]));
  if (!expires) refuse(fmt::format("expires '{}', expected a date such as 2026-11-22", c[6]));
  const auto days = (*expires - *since).count();
  if (days < 0 || days > longest_known)
    refuse(fmt::format("expires {} days after {}, expected 0 to {}: what is not mended by then is reviewed", days, c[5],
                       longest_known));
  return {c[0], c[1], c[2], c[3], vnv::current_name(c[4]), c[5], c[6], c[7]};
}

auto claim(const KnownFailure& k) { return std::tie(k.case_name, k.method, k.level, k.quantity); }

}  // namespace

bool KnownFailure::covers(const vnv::Verdict& v) const {
  return claim(*this) == std::tuple(v.case_name, v.method, v.level, with_unit(v.quantity, v.unit));
}

std::vector<KnownFailure> read_known_failures(const std::filesystem::path& file) {
  const vnv::Sheet sheet = vnv::read_sheet(file, true);
  vnv::require_headings(sheet, failure_columns);
  std::vector<KnownFailure> all;
  for (const auto& row : sheet.rows) {
    KnownFailure known = failure_on(sheet, row);
    for (const KnownFailure& other : all) {
      if (other.id == known.id)
        throw vnv::BadData(file, row.line, fmt::format("duplicate id; found '{}' twice, expected it once", known.id));
      if (claim(other) == claim(known))
        throw vnv::BadData(file, row.line,
                           fmt::format("duplicate claim; found that of '{}' again, expected it once", other.id));
    }
    all.push_back(std::move(known));
  }
  return all;
}

std::string NightStatus::sentence() const {
  std::string text =
      fmt::format("{} red: {}, {}; {} known", red_count(), counted(std::ssize(unknown), "unknown or expired failure"),
                  counted(std::ssize(unexpected_passes), "unexpected pass"), known.size());
  if (inconclusive > 0) text += fmt::format("; {} inconclusive", inconclusive);
  for (const std::string& words : {claims.missing, claims.note})
    if (!words.empty()) text += "\n" + words;
  return text;
}

NightStatus night_status(const std::vector<CaseRecords>& cases, const std::vector<KnownFailure>& known,
                         const std::string& today) {
  NightStatus result;
  std::vector<long> judged(known.size()), failed(known.size());
  for (const auto& verdict : verdicts_of(cases)) {
    const auto row = std::ranges::find_if(known, [&](const KnownFailure& k) { return k.covers(verdict); });
    const bool fails = verdict.outcome == vnv::Outcome::fails;
    const bool excused = row != known.end() && !row->is_expired(today);
    ++result.judged;
    result.inconclusive += verdict.outcome == vnv::Outcome::inconclusive;
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

}  // namespace touchstone::reports
