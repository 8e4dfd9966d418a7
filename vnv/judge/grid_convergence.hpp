#pragma once

#include <string>
#include <vector>

namespace touchstone::vnv {

/// A value at a spacing [any one unit each].
struct AtSpacing {
  double spacing, value;
};

/// What three resolutions say of a quantity whose exact value nobody knows.
///
/// The law f = f0 + c h^p passes through all three where they approach a value from one side; `extrapolated` is f0
/// (Richardson 1911) and `index` the grid convergence index of the finest, 1.25 |f0 - f|, in the unit of the value
/// (Roache, J. Fluids Eng. 116 (1994), 405-413, with the factor for three resolutions of Roache, Verification and
/// Validation in Computational Science and Engineering (1998); of any ratio Celik et al., J. Fluids Eng. 130 (2008),
/// 078001). Where the values swing, part or do not change, no power law passes, and none of the three is a
/// number.
struct GridConvergence {
  enum class Trend { monotone, oscillating, diverging, constant };
  Trend trend = Trend::monotone;
  double order, extrapolated, index;
};

/// Throws std::invalid_argument with one line unless the spacings are positive and fall from coarse to fine, and all
/// values are finite.
GridConvergence grid_convergence(const AtSpacing& coarse, const AtSpacing& middle, const AtSpacing& fine);

/// The standard uncertainty u_num of a value at the finest spacing of a ladder, in its unit, the half-width of the
/// 95 % interval that it stands for, as the sources of the rules define it, and by which rule.
struct NumericalUncertainty {
  double standard, interval;
  std::string basis;
};

/// By the finest three resolutions where they tell an order: the grid convergence index, of which the order is at most
/// `formal_order`, that of the method, as a higher one makes the index too small (Oberkampf & Roy, Verification and
/// Validation in Scientific Computing (2010), chapter 8). The sign of such an error is known, so u_num is to be no less
/// than the extrapolated error itself, the index by 1.25: it is the index by 1.15. By 2, as an interval of 95 % of an
/// error of either sign is, it would be less.
///
/// Where they do not, as the values swing, part or stand still, or the order is below 0.5, no extrapolation is trusted:
/// three times the range of all values of the ladder is the interval (Eça & Hoekstra, J. Comput. Phys. 262 (2014),
/// 104-130, whose factor is 3 for values that no law fits), of an error of either sign, so u_num is that by 2. Two
/// resolutions take the formal order, with a factor of 3 instead of 1.25 (Roache 1994); so do the first and the last of
/// three where the observed order is above twice the formal one, since then the finest two agree by chance. Of fewer
/// than two u_num is not a number.
///
/// Throws std::invalid_argument unless the ladder is from coarse to fine, its values are finite and the formal order is
/// positive.
NumericalUncertainty numerical_uncertainty(const std::vector<AtSpacing>& ladder, double formal_order);

}  // namespace touchstone::vnv
