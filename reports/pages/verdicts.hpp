#pragma once
/// Verdicts as a reader meets them: counted, listed and tabulated.

#include "reports/read/cases.hpp"
#include "reports/text/html.hpp"

#include <string>
#include <vector>

namespace touchstone::reports {

/// "12 of 15 claims hold, 2 fail, 1 is inconclusive. Theory set the limits of 5; 10 say no more than that values are as
/// last accepted."
std::string sentence(const Tally& tally);

/// A cell with the outcome as a word and a colour. A baseline that holds does not say that a method is right.
HtmlCell outcome_cell(const vnv::Verdict& verdict);

/// "23 %" with a bar of that fraction of the limit; negative and the other colour if the claim fails.
std::string margin_bar(double margin);

/// The sentences of all claims of this outcome; empty without any.
std::string list_of(vnv::Outcome outcome, const std::vector<vnv::Verdict>& verdicts);

/// Every claim with value, limit, author and margin, and what explains its error where that was asked; empty without
/// claims.
std::string verdict_table(const CaseRecords& records);

/// Of each diagnosed error what is named, or else the best, with the fitted values; empty without diagnoses.
std::string diagnosis_table(const CaseRecords& records);

/// The page of the claims of all cases. Stands beside the index.
std::string verdicts_page(const std::vector<CaseRecords>& cases);

}  // namespace touchstone::reports
