#pragma once
/// Quantity: what a number of a record is. It is declared once, where the number is measured; claims, orders,
/// baselines, pages and the gate ask it and guess nothing from its name.

#include <array>
#include <limits>
#include <string>
#include <string_view>

namespace touchstone::vnv {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

enum class Kind {
  norm,             // of a discretisation error: orders are observed of it
  error,            // the size of another error: a root mean square, a roughness
  deviation,        // an error with a sign
  invariant,        // how far from kept is what should be
  stability_limit,  // a largest stable step, a stable part of a map
  order,            // an observed order of convergence
  probability,      // a p-value
  cost,             // a time or a memory: another run of the same program finds another
  count,
  value,  // anything else
};
constexpr auto words(Kind) {  // in the order of the enumerators
  return std::to_array<std::string_view>(
      {"norm", "error", "deviation", "invariant", "stability limit", "order", "probability", "cost", "count", "value"});
}

/// Which way a quantity gets better.
enum class Better { undeclared, smaller, larger, nearer_zero };
constexpr auto words(Better) {
  return std::to_array<std::string_view>({"undeclared", "smaller", "larger", "nearer zero"});
}
constexpr Better usually_better(Kind kind) {
  switch (kind) {
    case Kind::norm:
    case Kind::error:
    case Kind::cost:
      return Better::smaller;
    case Kind::deviation:
    case Kind::invariant:
      return Better::nearer_zero;
    case Kind::stability_limit:
    case Kind::probability:
      return Better::larger;
    default:
      return Better::undeclared;
  }
}

struct Quantity {
  std::string name{};  // "L2 v_x, row means"
  std::string unit{};  // "%"; empty: a pure number
  Kind kind = Kind::value;
  Better better = usually_better(kind);

  /// "L2 v_x, row means [%]", as columns of tables and baselines have it; "[-]" for a pure number.
  std::string heading() const { return name + " [" + (unit.empty() ? "-" : unit) + "]"; }

  bool operator==(const Quantity&) const = default;
};

/// A quantity of which only the heading is known: "L2 v_x [%]" is "L2 v_x" in "%".
inline Quantity with_heading(const std::string& heading) {
  const std::size_t bracket = heading.rfind(" [");
  if (bracket == std::string::npos || !heading.ends_with(']')) return {heading};
  const std::string unit = heading.substr(bracket + 2, heading.size() - bracket - 3);
  return {heading.substr(0, bracket), unit == "-" ? "" : unit};
}

}  // namespace touchstone::vnv
