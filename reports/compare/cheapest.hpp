#pragma once
/// Which method has the least to pay for an error.

#include "reports/compare/orders.hpp"
#include "vnv/record/work_precision.hpp"

#include <optional>

namespace touchstone::reports {

/// The CPU time of the two cheapest methods to the same error.
struct Cheapest {
  struct Price {
    std::string method;
    vnv::TimeToError time;
  };
  double error;  // the smallest that two methods reach, in the unit of the quantity
  Price best, next;
};

/// By all runs of the case, on ladders or not, each charged for as far as it went when its error was measured. Equal
/// spacing would be no fair measure: a step of one method costs many times that of another. Nothing if fewer than two
/// methods have errors and times, or if they were not run on one machine.
std::optional<Cheapest> cheapest(const CaseRecords& records, const Subject& subject);

}  // namespace touchstone::reports
