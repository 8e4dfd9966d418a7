#pragma once
#include "vnv/record/observed_order.hpp"

#include <vector>

namespace touchstone::vnv {

/// Observed order of convergence p of errors ~ spacing^p over a ladder from coarse to fine, and what the ladder says of
/// the method.
///
/// p is the slope of the least-squares line through (log spacing, log error); it is positive when the errors shrink and
/// negative when they grow. `half_width` is that of the 95 % interval of the slope by Student's t with n - 2 degrees of
/// freedom (Draper & Smith, Applied Regression Analysis, 1998, chapter 1): infinite for two levels, which leave nothing
/// to judge the scatter by. `pairwise` holds the order between neighbouring levels; a tail that falls towards the fine
/// end is the signature of a floor. With fewer than two levels, or with an error that is zero, negative or not finite,
/// order and half-width are not numbers, and so are the pairs of that error: no power law passes there.
///
/// A floor is found if errors ~ floor + spacing^p scatter less than those of a power law by more than chance does once
/// in twenty times (F test of one more parameter, the same, chapter 6), if its interval is narrower than half of itself
/// to each side, and if it is more than a hundredth of the finest error. Then `order_to_floor` is the p of that law.
///
/// The trend is
/// - stalled if a floor is more than half of the finest error, or if the whole interval of p lies within 0.5 of 0;
/// - diverging if the whole interval of p is negative;
/// - converging if the whole interval of p, above a floor if there is one, is positive;
/// - inconclusive else, as with two levels or with an error that is no positive number.
///
/// The ladder is asymptotic if its two finest pairs have the order p, above a floor if there is one, within a tenth.
///
/// Spacings [m] and errors [any one unit] are equally many and come back in the result; the caller names ladder,
/// quantity, time and levels. Throws std::invalid_argument unless the spacings are finite, positive and falling.
ObservedOrder observe_order(std::vector<double> spacings, std::vector<double> errors);

}  // namespace touchstone::vnv
