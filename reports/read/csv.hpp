#pragma once
/// Tables for other programs: comma-separated, quoted as in RFC 4180, units in the headings.

#include "reports/read/cases.hpp"
#include "vnv/files/tables.hpp"

#include <string>
#include <vector>

namespace touchstone::reports {

using vnv::csv_field, vnv::csv_line;

/// One line per claim. Fields that do not apply are empty; a value that is not a number is "nan".
std::string verdicts_csv(const std::vector<CaseRecords>& cases);

/// One line per value.
std::string values_csv(const std::vector<CaseRecords>& cases);

/// One line per quantity, time and ladder of a method.
std::string orders_csv(const std::vector<CaseRecords>& cases);

/// One line per run.
std::string cost_csv(const std::vector<CaseRecords>& cases);

}  // namespace touchstone::reports
