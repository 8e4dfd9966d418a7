#pragma once
/// Whether an order of convergence changed.

#include "vnv/gate/compare_values.hpp"

namespace touchstone::gate {

/// A fall by this much is noticed, however wide the intervals.
inline constexpr double noticed_fall = 0.3;
/// Orders this near to each other are the same.
inline constexpr double same_order = 0.05;

/// By how much an order [-] may move while each error of its ladder keeps within a fraction of itself: the slope of the
/// line through errors that are off by that fraction, each the way that tilts it most.
double tilt_by(double fraction, const std::vector<double>& spacings);

/// Judges an order by its 95 % interval and by `explained`, what the tolerance of its errors explains. A smaller order
/// is never better, and a negative one is smaller than any positive. In between, where the intervals overlap, a fall is
/// inconclusive and a rise the same. A rise of orders that rest on two points, and so have no interval, is unjudged.
Reason compare_orders(const vnv::ObservedOrder& before, const vnv::ObservedOrder& after, double explained);

}  // namespace touchstone::gate
