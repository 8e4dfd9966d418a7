#pragma once
/// What an error costs in the methods of a case: work-precision diagrams with their tables, and the cheapest method.

#include "reports/compare/orders.hpp"
#include "vnv/record/work_precision.hpp"

#include <optional>

namespace touchstone::reports {

/// Adds to the records of a case, for each work-precision diagram that they declare, a figure with every method's
/// front, the runs that no method beats and what was measured elsewhere; a table of the CPU time to given errors; and
/// one of `cost_ratios`, if that has rows. A method takes part by having measured the quantity of the diagram at the
/// same time, whoever declared it; those that occupy another resource than CPU time have a diagram of their own. Where
/// several machines ran the methods, the one that ran most is compared; those of others are measured elsewhere.
void add_work_precision(CaseRecords& records);

/// A work-precision diagram with all that a page shows of it.
struct Work {
  vnv::WorkDiagram diagram;
  double time;  // s  of the errors
  std::vector<vnv::WorkPoint> points;
  std::string machine;  // that ran what was not measured elsewhere
};
/// The first that a case declares, against CPU time, or else one of the first norm or other error that most of its
/// methods measured; nothing where none is measured. Its own id is empty where no page draws it.
std::optional<Work> work_of(const CaseRecords& records);

/// CPU time of SPH over that of the cheapest MPM, once at equal particle number, the way of Sun et al., and once at
/// equal error. Without rows if there is nothing of the one or the other.
vnv::Table cost_ratios(const vnv::WorkDiagram& diagram, const std::vector<vnv::WorkPoint>& points);

/// The CPU time of the two cheapest methods to the same error.
struct Cheapest {
  struct Cost {
    std::string method;
    vnv::TimeToError time;
  };
  double error;  // the smallest that two methods reach, in the unit of the quantity
  Cost best, next;
  std::string machine;  // that ran both
};

/// "≤ 1.2 s"
std::string rounded(const vnv::TimeToError& time);

/// By all runs of the case, on ladders or not, each charged for as far as it went when its error was measured. Equal
/// spacing would be no fair measure: a step of one method costs many times that of another. Nothing if fewer than two
/// methods have errors and times. Where several machines ran them, those that one ran, the most, are compared.
std::optional<Cheapest> cheapest(const CaseRecords& records, const Subject& subject);

}  // namespace touchstone::reports
