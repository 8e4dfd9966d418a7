#pragma once
/// The shift of the error against run time, as a figure that reports can draw.

#include "vnv/gate/comparison.hpp"

namespace touchstone::gate {

/// A record of two curves for each method, before and after, in one figure for each case: the runs that none of their
/// own beats in both error and CPU time, or that of the resource they occupied, in a figure of its own. Times are
/// medians over the runs; the error is the first in the record that is one and no rounding, at the end of each level.
/// Methods without such runs are left out.
vnv::Record error_against_time(const std::vector<Records>& before, const std::vector<Records>& after);

}  // namespace touchstone::gate
