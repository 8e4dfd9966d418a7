#pragma once
/// The observed orders of a case, put together so that methods can be compared.

#include "reports/read/cases.hpp"

#include <optional>
#include <string>
#include <vector>

namespace touchstone::reports {

/// What errors are of.
struct Subject {
  std::string quantity;
  double time;  // s

  /// Times agree to nine digits.
  bool is(const std::string& its_quantity, double its_time) const;
};

/// One method along one of its ladders.
struct OrderLine {
  std::string method;
  std::size_t place;  // of the method among those of the case that have orders
  vnv::ObservedOrder order;
};

/// The orders of several methods in one quantity at one time.
struct OrderComparison {
  Subject subject;
  std::vector<OrderLine> lines;

  /// "order_L2_v_x_at_0_1_s": of its figure.
  std::string id() const;
  /// Those of a method; more than one if several of its ladders are shown.
  std::vector<OrderLine> of_method(const std::string& method) const;
  /// "mpm", and with its ladder where another line is of the same method.
  std::string name_of(const OrderLine& line) const;
};

enum class Field { velocity, pressure };

/// The comparison in which a case says most of a field: in the L2 norm that a claim of order names, or else in the
/// first one measured; of several times that at which most methods have three spacings or more, the latest of equal
/// ones. A method is shown along the ladders that the case's claims name, or else along its longest.
std::optional<OrderComparison> principal_comparison(const CaseRecords& records, Field field);

/// The principal ones, and all others that a claim of order speaks of.
std::vector<OrderComparison> order_comparisons(const CaseRecords& records);

}  // namespace touchstone::reports
