#pragma once
/// Work-precision diagrams: the runs of a method as points, what an error costs as a value that claims may judge, and
/// the study of a flow by which all its methods get theirs.

#include "vnv/case.hpp"
#include "vnv/record/record.hpp"

#include <string>
#include <vector>

namespace touchstone::vnv {

/// The finished runs of a method as points of a diagram: the largest magnitude of its quantity at these times [s], and
/// the CPU time until the last. Errors of opposite signs may cancel: a run of a study counts with that of the next
/// finer run of its combination where that is larger.
std::vector<WorkPoint> work_points(const WorkDiagram& diagram, const std::vector<double>& times, const Results& results,
                                   const Record& record);

/// Adds the diagram, the method's points, and points that were measured elsewhere.
Plot error_against_run_time(WorkDiagram diagram, std::vector<double> times, std::vector<WorkPoint> elsewhere = {});

/// The name of the CPU time to an error of a diagram: "CPU time to 1 % [s]".
Quantity price_of(const WorkDiagram& diagram, double target);

/// The CPU times to the diagram's targets; not a number where none of the method's runs is good enough.
Finding prices(WorkDiagram diagram, std::vector<double> times);

/// Over what the methods of a flow are run to see what an error costs: all combinations, cheapest first, until the
/// budget is spent. Of those that differ in the spacing alone a finer one is not run where another of that sound speed
/// had two thirds of the error of the next coarser one at no more cost.
struct WorkStudy {
  Quantity error;
  std::vector<double> times;  // s  the largest error at these counts; a whole number of the first is each other
  double length;              // m  so many cells of MPM, or particles of SPH, are across it
  std::vector<int> cells{4, 6, 8, 10, 14, 20, 28, 40, 56, 80, 112}, particles{10, 14, 20, 28, 40, 56, 80, 112, 160};
  std::vector<int> points{1, 2, 3};             // along a side of a cell
  std::vector<double> kernels{1, 1.2, 1.5};     // smoothing length over spacing
  std::vector<double> steps{2, 1.4, 1};         // over the step that the method takes
  double largest_speed = not_a_number;          // m/s  of the flow
  std::vector<double> stiffness{not_a_number};  // sound speed over that; not a number: that of the scene
  /// Period [m] along x of the scene of a flow in which nothing varies there: only a strip of it is computed.
  double period = not_a_number;
  std::vector<double> targets{3, 1, 0.3, 0.1, 0.03, 0.01};
  double ranked_by = 1;
  double budget = 15;  // s  user time of a method

  WorkDiagram diagram() const;
};

/// The case with levels, diagram and a claim for the suite `work`, for all its methods that say which step they take;
/// where the sound speed is varied, with what it does to the error, too. What others measured stands beside.
Case with_work(Case declared, const WorkStudy& study, std::vector<WorkPoint> elsewhere = {});

}  // namespace touchstone::vnv
