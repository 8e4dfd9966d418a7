#pragma once
/// The page of the project's own detection rate: which tests notice which seeded fault, and by how much.

#include "reports/read/fault_trials.hpp"

#include <string>

namespace touchstone::reports {

/// Stands beside the index, and the table faults.csv beside it.
std::string fault_page(const FaultTrials& trials);

}  // namespace touchstone::reports
