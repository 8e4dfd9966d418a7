#pragma once
/// Two sets of records, compared thing by thing. Nothing is known of solvers here.

#include "vnv/gate/difference.hpp"
#include "vnv/record/record.hpp"

#include <vector>

namespace touchstone::gate {

using Records = std::vector<vnv::Record>;

/// Everything that was compared, what is the same too: runs, claims, values and orders.
///
/// A method, run, value, order or claim that is gone is worse, since something is no longer measured; a new one is
/// unjudged. A run that ended and diverges now is worse. A claim is worse when it held and now fails or is
/// inconclusive, and inconclusive when its limits now allow more; a baseline that fails because its value got better is
/// better. What belongs to the machine is unjudged.
///
/// Each side has at most one record of a method; throws std::invalid_argument for a second one.
std::vector<Difference> compare(const Records& before, const Records& after);

/// The same for programs that ran more than once, by their first runs. What varied between the runs before is unjudged;
/// what varies only now is inconclusive at least. There is at least one run of each.
std::vector<Difference> compare_repeated(const std::vector<Records>& before, const std::vector<Records>& after);

}  // namespace touchstone::gate
