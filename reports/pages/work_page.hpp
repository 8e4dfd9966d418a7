#pragma once
/// The page that shows, over all flows, what an error costs and which method is cheapest.

#include "reports/read/cases.hpp"

#include <string>
#include <vector>

namespace touchstone::reports {

/// Whether a flow has a work-precision diagram of its own methods.
bool is_priced(const CaseRecords& records);

/// Stands beside the index.
std::string work_page(const std::vector<CaseRecords>& cases);

/// The same for programs, and for data/work.csv, by which `vnv explain` names the default method of a flow.
std::string work_csv(const std::vector<CaseRecords>& cases);

}  // namespace touchstone::reports
