#include "reports/read/claims.hpp"

#include "reports/text/notation.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::reports {
namespace {

const vnv::Record* record_of(const vnv::ClaimCount& accepted, const std::vector<CaseRecords>& cases) {
  for (const CaseRecords& one : cases)
    for (const vnv::Record& record : one.records)
      if (record.case_name == accepted.case_name && record.method == accepted.method && record.suite == accepted.suite)
        return &record;
  return nullptr;
}

/// Names of methods, and how many claims they have.
struct Named {
  long claims = 0;
  std::vector<std::string> names{};

  void add(long count, std::string name) {
    claims += count;
    names.push_back(std::move(name));
  }
};

Named missing_among(const std::vector<CaseRecords>& cases, const std::vector<vnv::ClaimCount>& accepted, bool whole,
                    long& not_run) {
  Named missing;
  for (const vnv::ClaimCount& row : accepted) {
    const vnv::Record* record = record_of(row, cases);
    not_run += !record && !whole;
    if ((!record && !whole) || (record && tally(record->verdicts).fails > 0)) continue;
    const vnv::ClaimCount found = record ? vnv::claims_in(*record) : vnv::ClaimCount{};
    if (const long count = missing_of(row, found))
      missing.add(count, fmt::format("{}.{} ({})", row.case_name, row.method, missing_in_words(row, found)));
  }
  return missing;
}

Named more_among(const std::vector<CaseRecords>& cases, const vnv::AcceptedClaims& accepted) {
  Named more;
  for (const CaseRecords& one : cases)
    for (const vnv::Record& record : one.records) {
      if (record.another_code) continue;
      const vnv::ClaimCount found = claims_in(record);
      const vnv::ClaimCount* row = accepted.find(found.case_name, found.method, found.suite);
      if (const long count = missing_of(found, row ? *row : vnv::ClaimCount{}))
        more.add(count, fmt::format("{}.{} ({})", found.case_name, found.method, count));
    }
  return more;
}

}  // namespace

ClaimsStatus claims_status(const std::vector<CaseRecords>& cases, const vnv::AcceptedClaims& accepted, bool whole) {
  const std::string suite = cases.front().records.front().suite;
  std::vector<vnv::ClaimCount> rows = accepted.rows;
  std::erase_if(rows, [&](const vnv::ClaimCount& row) { return row.suite != suite; });
  ClaimsStatus status;
  if (rows.empty()) {
    const auto is_ours = [](const CaseRecords& one) {
      return !std::ranges::all_of(one.records, &vnv::Record::another_code);
    };
    if (std::ranges::any_of(cases, is_ours))
      status.note = fmt::format(
          "No claims of the suite {0} were accepted yet; accept them with: build/vnv/vnv accept CASE --suite {0} --claims RECORDS --reason \"...\"",
          suite);
    return status;
  }
  long not_run = 0;
  const Named missing = missing_among(cases, rows, whole, not_run), more = more_among(cases, accepted);
  if (missing.claims > 0)
    status.missing =
        fmt::format("{} fewer than accepted: {}", counted(missing.claims, "claim"), fmt::join(missing.names, ", "));
  if (not_run > 0) status.note = fmt::format("{} of {} accepted methods were not run. ", not_run, rows.size());
  if (more.claims > 0)
    status.note += fmt::format(
        "{} more than accepted: {}; accept them with: build/vnv/vnv accept CASE --suite {} --claims RECORDS --reason \"...\"",
        counted(more.claims, "claim"), fmt::join(more.names, ", "), suite);
  return status;
}

}  // namespace touchstone::reports
