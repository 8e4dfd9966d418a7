#pragma once
/// The page over all nights: what changed, and how the numbers that matter went.

#include "reports/compare/series.hpp"

#include <string>
#include <vector>

namespace touchstone::reports {

/// Lines of the table of what changed; all steps are in trend_steps.csv.
inline constexpr std::size_t most_changes_listed = 100;

std::string trend_page(const History& history, const std::vector<Series>& all, const std::vector<CaseRecords>& tonight);

/// One line per step.
std::string steps_csv(const History& history, const std::vector<Series>& all);

/// One line per series that is drawn, one column per night, headed by its date and revision.
std::string trend_csv(const History& history, const std::vector<Series>& all);

}  // namespace touchstone::reports
