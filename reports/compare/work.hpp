#pragma once
/// Value against run time of all methods of a case: the figure, what an error costs, and how that differs from
/// comparing at equal particle number.

#include "reports/read/cases.hpp"

namespace touchstone::reports {

/// Adds to the records of a case, for each diagram that they declare, a figure with every method's front, the runs that
/// no method beats, what was measured elsewhere, and two tables.
void add_work(CaseRecords& records);

}  // namespace touchstone::reports
