#pragma once
/// Whether a value changed, and which way.

#include "vnv/gate/difference.hpp"

#include <optional>
#include <utility>

namespace touchstone::gate {

/// A change of this fraction is noticed whatever a baseline allows: half of the 10 % in an error, and the 5 % in a
/// limit of stability, that no gate may miss.
inline constexpr double noticed = 0.05;
/// What a value without a baseline may change by: the tolerance of most baselines, by which builds for this processor
/// and for any processor differ.
inline constexpr double allowed_by_default = 0.02;
/// What another order of a sum leaves of zero, in any unit, as `vnv::Tolerance` has it.
inline constexpr double rounding_of_zero = 1e-12;

/// A change, with its reason.
using Reason = std::pair<Change, std::string>;

/// Judges a value by how far it may move, `tolerance` [its own unit], half the width between the limits of its
/// baseline. Within it, or within rounding of zero, it is the same, and beyond it better or worse by its declared
/// direction, or inconclusive if none is declared. A tolerance wider than what must be noticed is not believed: a
/// change for the worse inside it but beyond `noticed` is inconclusive. One of half the value and more says that the
/// value is not one to be compared (the error of a run that need not be right): inside it nothing is judged. What is no
/// finite number is worse after one that is.
Reason compare_values(double before, double after, vnv::Better better, std::optional<double> tolerance);

}  // namespace touchstone::gate
