#pragma once
/// The methods of all flows, as the front page shows them.

#include "reports/pages/template.hpp"
#include "reports/read/known_failures.hpp"

#include <vector>

namespace touchstone::reports {

/// Error against run time in one flow, beside it how many methods are right on whose word and which are farthest off;
/// then the tables of all flows and of all other cases, with what each method reaches and is called. Data of the index.
Data overview_data(const std::vector<CaseRecords>& cases, const NightStatus& status);

}  // namespace touchstone::reports
