#pragma once
/// A number that was measured of a run.

#include "vnv/record/quantity.hpp"

#include <string>

namespace touchstone::vnv {

/// One number that was measured of one run.
struct Value {
  std::string level;
  double spacing = 0;  // m
  double time = 0;     // s
  Quantity quantity;
  double value = not_a_number;  // in the unit of the quantity

  bool operator==(const Value&) const = default;
};

}  // namespace touchstone::vnv
