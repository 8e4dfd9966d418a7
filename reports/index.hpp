#pragma once
/// The first page: how much holds, which case and method to look at, and where it was run.

#include "reports/cases.hpp"

#include <string>
#include <vector>

namespace touchstone::reports {

std::string index_page(const std::vector<CaseRecords>& cases);

}  // namespace touchstone::reports
