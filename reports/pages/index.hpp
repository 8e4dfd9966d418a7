#pragma once
/// The first page: how much holds, the cases and their methods, and where it was run.

#include "reports/read/fault_trials.hpp"
#include "reports/read/known_failures.hpp"

#include <optional>
#include <string>
#include <vector>

namespace touchstone::reports {

/// With a history it leads to the trend, too, and with trials of faults to their page.
std::string index_page(const std::vector<CaseRecords>& cases, const NightStatus& status, bool has_trend,
                       const std::optional<FaultTrials>& faults = {});

}  // namespace touchstone::reports
