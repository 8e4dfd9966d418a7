#pragma once
/// What became of a claim.

#include "vnv/record/quantity.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace touchstone::vnv {

enum class Outcome { holds, fails, inconclusive };
constexpr auto words(Outcome) { return std::to_array<std::string_view>({"holds", "fails", "inconclusive"}); }

/// A claim, judged.
struct Verdict {
  std::string case_name, method, level;
  double spacing = not_a_number;  // m
  double time = not_a_number;     // s
  std::string quantity;           // "L2 v_x, row means", "order of L2 over grid"
  std::string unit;               // "%", "m"; empty for a pure number
  Kind kind = Kind::value;
  Better better = Better::undeclared;
  double value = not_a_number;         // in `unit`
  std::optional<double> lower, upper;  // in `unit`; the limits that are claimed
  std::string author;                  // "theory: ...", "literature: ...", "baseline: ..."
  Outcome outcome = Outcome::inconclusive;
  double margin = not_a_number;  // fraction of the limit left, negative if it fails
  std::string sentence;          // all of it, for a person

  bool operator==(const Verdict&) const = default;
};

}  // namespace touchstone::vnv
