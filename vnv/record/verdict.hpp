#pragma once
/// What became of a claim.

#include "vnv/record/observed_order.hpp"
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
  double value = not_a_number;           // in `unit`
  std::optional<double> lower, upper;    // in `unit`; the limits that are claimed
  std::optional<double> surely_above{};  // of an order that is claimed to converge: where its interval has to begin
  std::optional<double> half_width{};    // of an observed order: of its 95 % interval
  Trend trend = Trend::inconclusive;     // of an observed order
  std::string author;                    // "theory: ...", "literature: ...", "baseline: ..."
  Outcome outcome = Outcome::inconclusive;
  double margin = not_a_number;  // fraction of the limit left, negative if it fails
  std::string sentence;          // all of it, for a person

  bool operator==(const Verdict&) const = default;
};

/// What the numbers of a verdict come to, its recorded outcome aside: the only place where that is decided, for who
/// judges and for who reads a record. Written so that a value that is not a number fails; without any limit nothing is
/// decided, and an order is decided only where its interval is narrow.
Outcome outcome_of(const Verdict& verdict);

/// Fraction of a limit that is left, or of half the width between two.
double margin_of(const Verdict& verdict);

}  // namespace touchstone::vnv
