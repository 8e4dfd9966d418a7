#pragma once
/// Whether what was claimed still holds.

#include "vnv/gate/compare_values.hpp"

namespace touchstone::gate {

/// Judges two verdicts on one claim. Worse if it held and now fails or is inconclusive, or was inconclusive and fails,
/// unless a baseline is left because its value got better, which is better. Inconclusive if it holds as before, but by
/// limits that allow more: those of theory and literature, and of a baseline if it got wider than its value got larger.
/// Unjudged if it is on a time or a memory.
Reason compare_verdicts(const vnv::Verdict& before, const vnv::Verdict& after);

}  // namespace touchstone::gate
