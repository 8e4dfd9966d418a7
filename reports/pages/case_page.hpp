#pragma once
/// The page of one case: what was solved, how it compares, and what is claimed.

#include "reports/figures/figures.hpp"

#include <string>
#include <vector>

namespace touchstone::reports {

/// Stands in the case's folder, beside its figures.
std::string case_page(const CaseRecords& records, const Plots& figures, const Plots& order_plots);

}  // namespace touchstone::reports
