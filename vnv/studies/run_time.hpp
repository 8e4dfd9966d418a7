#pragma once
/// Work-precision diagrams: the runs of a method as points, and what an error costs as a value that claims may judge.

#include "vnv/case.hpp"
#include "vnv/record/record.hpp"

#include <string>
#include <vector>

namespace touchstone::vnv {

/// The finished runs of a method as points of a diagram: its quantity at a time [s], and the CPU time until then.
std::vector<WorkPoint> work_points(const WorkDiagram& diagram, double time, const Results& results,
                                   const Record& record);

/// Adds the diagram, the method's points, and points that were measured elsewhere.
Plot error_against_run_time(WorkDiagram diagram, double time, std::vector<WorkPoint> elsewhere = {});

/// The name of the CPU time to an error of a diagram: "CPU time to 1 % [s]".
Quantity price_of(const WorkDiagram& diagram, double target);

/// The CPU times to the diagram's targets; not a number where none of the method's runs is good enough.
Finding prices(WorkDiagram diagram, double time);

}  // namespace touchstone::vnv
