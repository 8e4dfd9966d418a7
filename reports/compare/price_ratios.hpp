#pragma once
#include "vnv/record/record.hpp"

#include <vector>

namespace touchstone::reports {

/// CPU time of SPH over that of the cheapest MPM, once at equal particle number, the way of Sun et al., and once at
/// equal error; with a sentence that says how the answer changes. Without rows if there is nothing of the one or the
/// other.
vnv::Table price_ratios(const vnv::WorkDiagram& diagram, const std::vector<vnv::WorkPoint>& points);

}  // namespace touchstone::reports
