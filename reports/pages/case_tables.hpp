#pragma once
/// The tables of a case, as HTML. Each is empty if the records bring nothing for it.

#include "reports/read/cases.hpp"

#include <string>

namespace touchstone::reports {

/// The tables that the records bring themselves, such as the paper's numbers beside ours.
std::string tables_html(const CaseRecords& records);

/// One row per run, one column per norm and time.
std::string errors_html(const CaseRecords& records);

/// One row per ladder and quantity, with the 95 % interval and the orders between neighbouring levels.
std::string orders_html(const CaseRecords& records);

/// One row per run: particles, steps, time, memory, and how it ended.
std::string cost_html(const CaseRecords& records);

}  // namespace touchstone::reports
