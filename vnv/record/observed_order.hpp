#pragma once
/// What a ladder of errors says of the order of convergence.

#include "vnv/record/quantity.hpp"
#include "vnv/record/word_of.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv {

/// What a ladder of errors says of a method; `observe_order` tells them apart.
enum class Trend { converging, stalled, diverging, inconclusive };
constexpr auto words(Trend) {
  return std::to_array<std::string_view>({"converging", "stalled", "diverging", "inconclusive"});
}

/// An observed order of convergence with its 95 % interval, and the floor that the errors fall to, if one was found.
struct ObservedOrder {
  std::string ladder;    // "grid, 4 points per cell"
  std::string quantity;  // heading of what was measured, "L2 v_x, row means [%]"
  double time = 0;       // s
  double order = not_a_number;
  double half_width = not_a_number;  // of the 95 % interval
  Trend trend = Trend::inconclusive;
  bool asymptotic = false;                                       // the finest pairs have the order of all
  double floor = not_a_number, floor_half_width = not_a_number;  // in the unit of the errors; of the 95 % interval
  double order_to_floor = not_a_number, order_to_floor_half_width = not_a_number;
  std::vector<std::string> levels;  // coarse to fine, as the three below
  std::vector<double> spacings;     // m
  std::vector<double> errors;
  std::vector<double> pairwise;  // one fewer than levels

  bool operator==(const ObservedOrder&) const = default;
};

}  // namespace touchstone::vnv
