#pragma once
/// What is wrong, not only that it is wrong: causes of an error are fitted to it, each with its 95 % interval.

#include "vnv/flows/flow.hpp"
#include "vnv/record/diagnosis.hpp"

#include <vector>

namespace touchstone::vnv::doors {

/// One resolution of a code: its samples at one or many times.
struct Diagnosed {
  std::vector<const Samples*> samples;
  double spacing;  // m  the unit of walls
};

/// Fits each cause of the field's flow, two at once where no single one suffices, and noise, to the error of each
/// resolution, by least squares over exact fields of flows in which that is wrong. Each time counts by its error
/// relative to the exact field, each sample by its volume. Never throws for what samples hold: where no diagnosis can
/// be made the sentence says so. Rows without a number are left out, and told; so are a few whose error stands apart
/// from all others.
///
/// First come mistakes that are made or not (mistakes.hpp): one is named that leaves a fifth of the squared error or
/// less, unless one or two causes leave a tenth of that; what it leaves is diagnosed in turn.
///
/// One cause suffices if it explains four fifths of that of the squared error which is no noise (what is 3 times as
/// large as the rest of an error explains 9 tenths) and differs from zero (5 %). With it are named all others that
/// suffice and to which the best adds nothing significant (1 %): these data cannot tell them apart. Two causes are
/// named where none suffices, or where they leave a tenth of what one leaves and that is more than 0.5 %. Noise that is
/// left is named with them. Where one leaves a ten thousandth of the error at most, only those are named with it that
/// leave a thousandth; where nothing explains an error that is all of one time, that time is diagnosed alone. None is
/// named or offered that is less than the half-width of its interval. Where none is, the sentence says where the error
/// lies (where.hpp). At most 1500 samples at each of at most 6 times are used.
///
/// Intervals hold what is random and what discretisation may make. The first is that of least squares under errors that
/// are correlated in space and time: their spectrum over waves in the box and their correlation between times are those
/// of what is left (a sandwich estimate of a covariance; Newey & West, Econometrica 55 (1987), 703-708), with Student's
/// t at the number of waves that hold it. The second cannot be seen in what is left: the error of a shear wave on a
/// grid *is* another viscosity. At one resolution it is taken as `discretisation` h² times the Laplacian of the slope
/// of the field with viscosity, with h the spacing: central differences make 1/12 of that, Euler's steps backward, as
/// long as forward ones may be, 1/3. At several, the values of a cause are extrapolated to vanishing spacing, the
/// interval of each reaches over that of the extrapolated, and what the finest names is named at all where it is more
/// than its interval. 0: samples are those of an exact field, and noise.
///
/// `others` are fields of the flow that the samples hold, too: what is wrong with the flow is not offered where one of
/// them would be twice as wrong by it.
std::vector<Diagnosis> diagnose(const Exact& exact, const std::vector<Diagnosed>& levels, const Domain& domain,
                                double discretisation = 0.3, const std::vector<const Exact*>& others = {});

}  // namespace touchstone::vnv::doors
