#pragma once
/// The page that shows how each method converges in each flow.

#include "reports/read/cases.hpp"

#include <string>
#include <vector>

namespace touchstone::reports {

/// Whether the matrix shows a flow: it has an order of velocity or pressure.
bool is_in_matrix(const CaseRecords& records);

/// Stands beside the index.
std::string order_matrix_page(const std::vector<CaseRecords>& cases);

}  // namespace touchstone::reports
