#pragma once
/// What is wrong, not only that it is wrong: causes of an error are fitted to it, each with its 95 % interval.

#include "vnv/doors/flow.hpp"
#include "vnv/record/diagnosis.hpp"

#include <vector>

namespace touchstone::vnv::doors {

/// Fits each cause of the field's flow, two at once where no single one suffices, and noise, to the error of samples at
/// one or many times, by least squares over exact fields of flows in which that is wrong. Each time counts by its error
/// relative to the exact field, each sample by its volume. `spacing` [m] is the unit of walls.
///
/// One cause suffices if it explains four fifths of the squared error (what is 3 times as large as the rest of an error
/// explains 9 tenths) and differs from zero (5 %). With it are named all others that suffice and to which the best adds
/// nothing significant (1 %): these data cannot tell them apart. Two causes are named where none suffices, or where
/// they leave a tenth of what one leaves and that is more than 2 %. Intervals are those of least squares under errors
/// that are correlated in space and time: their spectrum over waves in the box and their correlation between times are
/// those of what is left (a sandwich estimate of a covariance; Newey & West, Econometrica 55 (1987), 703-708), with
/// Student's t at the number of waves that hold it. At most 1500 samples at each of at most 6 times are used.
Diagnosis diagnose(const Exact& exact, const std::vector<const Samples*>& samples, const Domain& domain,
                   double spacing);

}  // namespace touchstone::vnv::doors
