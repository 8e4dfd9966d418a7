#pragma once
/// What a ladder of values says of a quantity whose truth is not known. Values in any one unit, coarse to fine.

#include "vnv/record/quantity.hpp"

#include <array>
#include <vector>

namespace touchstone::vnv {

struct GridConvergence {
  double order = not_a_number;
  double extrapolated = not_a_number;  // to spacing 0
  double index = not_a_number;         // GCI: half-width of a 95 % band about the finest value, as a share of it
  bool oscillates = false;             // the values jump to and fro, and the order means little
};

/// Grid convergence index of three values with safety factor 1.25 (Roache, J. Fluids Eng. 116 (1994), 405-413), its
/// order by iteration as Celik et al., J. Fluids Eng. 130 (2008), 078001. Not numbers where neighbouring values are
/// equal or not finite. Throws std::invalid_argument unless the spacings [m] are finite, positive and falling.
GridConvergence grid_convergence(const std::array<double, 3>& spacings, const std::array<double, 3>& values);

struct NumericalUncertainty {
  double extrapolated = not_a_number;  // to spacing 0, by the error estimator that was chosen
  double uncertainty = not_a_number;   // half-width of a 95 % band about the finest value
  double order = not_a_number;         // as fitted, before it was held to what can be believed
  double scatter = not_a_number;       // standard deviation of the values about the fit that was chosen
  double safety = not_a_number;        // factor on the error: 1.25 where the fit is good, else 3
};

/// Uncertainty of the finest of four or more values (Eça & Hoekstra, J. Comput. Phys. 262 (2014), 104-130): v0 + a h^p
/// is fitted, or where p is outside [0.5, 2] terms of first and second order, with and without weights 1 / h, whichever
/// scatters least; what the values scatter is part of the uncertainty. Not numbers for values that are not finite.
/// Throws std::invalid_argument for fewer than four values, or unless the spacings [m] are finite, positive and
/// falling.
NumericalUncertainty numerical_uncertainty(const std::vector<double>& spacings, const std::vector<double>& values);

}  // namespace touchstone::vnv
