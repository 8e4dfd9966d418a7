#pragma once

namespace touchstone::vnv {

/// A value at a spacing [any one unit each].
struct AtSpacing {
  double spacing, value;
};

/// What three resolutions say of a quantity whose exact value nobody knows.
///
/// The law f = f0 + c h^p passes through all three where they approach a value from one side; `extrapolated` is f0
/// (Richardson 1911) and `index` the grid convergence index of the finest, 1.25 |f0 - f|, in the unit of the value
/// (Roache, J. Fluids Eng. 116 (1994), 405-413; for three resolutions of any ratio Celik et al., J. Fluids Eng. 130
/// (2008), 078001). Where the values swing, part or do not change, no power law passes, and none of the three is a
/// number.
struct GridConvergence {
  enum class Trend { monotone, oscillating, diverging, constant };
  Trend trend = Trend::monotone;
  double order, extrapolated, index;
};

/// Throws std::invalid_argument with one line unless the spacings are positive and fall from coarse to fine, and all
/// values are finite.
GridConvergence grid_convergence(const AtSpacing& coarse, const AtSpacing& middle, const AtSpacing& fine);

}  // namespace touchstone::vnv
