#pragma once
/// Verdicts as a reader meets them: counted, listed and tabulated.

#include "reports/pages/template.hpp"
#include "reports/read/cases.hpp"

#include <string>
#include <vector>

namespace touchstone::reports {

/// "12 of 15 claims hold, 2 fail, 1 is inconclusive. Theory set the limits of 5; 10 say no more than that values are as
/// last accepted."
std::string sentence(const Tally& tally);

/// A level with whether it is long enough to take several lines.
Data level(const std::string& name);

/// A row of each item of all records; none without any.
Data rows_of(const CaseRecords& records, auto items, const auto& row) {
  List rows;
  for_each(records, items, [&](const auto& record, const auto& item) { rows.push_back(row(record, item)); });
  return if_any(rows);
}

/// Items of a list: the sentences of all claims of this outcome.
List sentences(vnv::Outcome outcome, const std::vector<vnv::Verdict>& verdicts);

/// Every claim with value, limit, author and margin, and what explains its error where that was asked.
Data claims_data(const CaseRecords& records);

/// Of each diagnosed error what is named, or else the best, with the fitted values.
Data diagnoses_data(const CaseRecords& records);

}  // namespace touchstone::reports
