#pragma once
/// From a declared case to a record: all runs of one method, their numbers, orders and verdicts.

#include "vnv/case.hpp"
#include "vnv/judge/baselines.hpp"
#include "vnv/record/accepted_claims.hpp"
#include "vnv/record/end_of_run.hpp"

namespace touchstone::vnv {

/// What files of a run are called, by its CASE.METHOD and its level: "couette.mpm.40_across".
std::string stem_of_files(const std::string& name, const std::string& level);

/// A record that says of whom it is, and nothing yet of any run.
Record record_of(const std::string& case_name, const Case& declared, const Method& method, Suite suite);

/// Runs a method on the levels of a suite and judges it by the claims of the case, of the method and of the baselines.
/// Without baselines nothing is claimed of them; with them, a value of the acceptance suite that has none is
/// inconclusive.
Record assess(const std::string& case_name, const Case& declared, const Method& method, Suite suite,
              const std::optional<Baselines>& baselines);

/// The same of runs that are there already.
Record assess(const std::string& case_name, const Case& declared, const Results& results,
              const std::optional<Baselines>& baselines);

/// Whether anything was claimed of a method but that its runs end, their fluid together.
bool claims_more_than_ends(const Record& record);

/// Why a method does not pass, line by line: nothing was claimed of it but ends, a claim does not hold, or all hold and
/// are fewer than accepted. Empty if it passes.
std::vector<std::string> complaints(const Record& record, const AcceptedClaims& accepted);

/// The rows by which a record's values become baselines.
std::vector<Baseline> baselines_from(const Record& record, const Tolerance& tolerance);

}  // namespace touchstone::vnv
