#pragma once
#include "vnv/case.hpp"

#include <string>
#include <vector>

namespace touchstone::vnv {

/// Runs each level that the suite asks for in a process of its own, then, in the suites that show cost, the short ones
/// again in turn, A B C A B C, as long as the budget lasts. A process that dies leaves a run that did not finish.
std::vector<Run> run_levels(const std::string& case_name, const Case& declared, const Method& method, Suite suite);

/// A level of any spacing [m]; its cell has as many particles along a side as that of the level of nearest spacing,
/// or is so much larger that the solver takes it: whole cells fill a domain, and rounding may make them too small.
Level level_at(const Method& method, double spacing);

}  // namespace touchstone::vnv
