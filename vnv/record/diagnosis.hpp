#pragma once
/// What is wrong with a field, as far as its error tells.

#include "vnv/record/quantity.hpp"

#include <string>
#include <vector>

namespace touchstone::vnv {

/// By how much one thing would be wrong. A mistake that is made or not has no interval, nor a unit where it has no
/// size.
struct FittedCause {
  std::string cause;                 // "viscosity", "upper wall"
  std::string unit;                  // "%", "spacings"
  double value = not_a_number;       // in it
  double half_width = not_a_number;  // in it; of the 95 % interval

  bool operator==(const FittedCause&) const = default;
};

/// One cause, or two at once, as an explanation of the error.
struct Explanation {
  std::vector<FittedCause> causes{};
  double share = not_a_number;  // of the squared error that it explains
  bool named = false;           // by the diagnosis; those that are named together cannot be told apart
  std::string sentence{};       // "the flow is that of a fluid 5.1 ± 0.2 % too viscous"

  bool operator==(const Explanation&) const = default;
};

/// "5.38 ± 0.13": a value of four digits at most, to those of its interval, which reaches to the last of them at least.
std::string in_digits_of_interval(double value, double half_width);

/// The value with its interval, without its unit; of what has no unit nothing.
std::string in_digits(const FittedCause& cause);

/// Of one field of one run, at all its times.
struct Diagnosis {
  std::string level{};
  std::string field;                      // "velocity"
  std::vector<std::string> quantities{};  // those of its verdicts: "L2 v_x, per particle" and the order of it
  double error = not_a_number;            // %  of the exact field: root of the mean square over its times
  std::vector<Explanation> explanations{};
  std::string sentence{};  // what is named, or that nothing is

  bool operator==(const Diagnosis&) const = default;
};

}  // namespace touchstone::vnv
