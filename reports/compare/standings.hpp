#pragma once
/// How the methods of a flow stand beside each other: how far off each is, how fast its errors fall, what an error
/// costs, and on whose word it is called right.

#include "reports/compare/work_precision.hpp"

#include <optional>
#include <vector>

namespace touchstone::reports {

/// Whether a claim of theory or literature says that a method is right in a flow: that its error is small, or falls as
/// the spacing does; where no error is measured, whatever it says of more than that runs reach their end. A baseline
/// never does: what is 51 % off stays so as accepted.
bool says_right(const vnv::Verdict& verdict, const std::optional<Work>& work);

struct Standing {
  const vnv::Record* record;
  std::vector<vnv::Verdict> right_by{};       // claims that say so and hold
  double error = vnv::not_a_number;           // the smallest that was reached, at the time that all are compared at
  std::optional<vnv::Value> at_end{};         // of the finest run at the last time that it was measured
  std::optional<vnv::ObservedOrder> order{};  // along the longest ladder, at the time that all are compared at
  vnv::TimeToError cost{};                    // to the error by which the flow is ranked
  bool is_most_accurate = false, is_cheapest = false;

  /// Whether one of those claims is of an order.
  bool converges() const;
};

/// The methods of a flow: the cheapest to the error by which it is ranked, else to the smallest that is asked for,
/// first; then those that do not reach it, by their errors.
struct Standings {
  const CaseRecords* records;
  std::optional<Work> work;  // without, no error is measured, and methods stand as in the records
  std::vector<Standing> methods;
};
Standings standings_of(const CaseRecords& records);

}  // namespace touchstone::reports
