#pragma once
/// Tables for other programs: comma-separated, quoted as in RFC 4180, units in the headings.

#include "reports/read/cases.hpp"

#include <string>
#include <vector>

namespace touchstone::reports {

/// A field, in quotes if it holds a comma, a quote or a line break.
std::string csv_field(const std::string& text);

/// A line of fields.
std::string csv_line(const std::vector<std::string>& fields);

/// One line per claim. Fields that do not apply are empty; a value that is not a number is "nan".
std::string verdicts_csv(const std::vector<CaseRecords>& cases);

/// One line per quantity, time and ladder of a method.
std::string orders_csv(const std::vector<CaseRecords>& cases);

/// One line per run.
std::string cost_csv(const std::vector<CaseRecords>& cases);

}  // namespace touchstone::reports
