#pragma once
/// Lines of equal colour through a cloud of particles.

#include "vnv/record/figure.hpp"

#include <vector>

namespace touchstone::reports {

/// A piece of a line, in the units of the cloud.
struct IsolinePiece {
  double x, y, to_x, to_y;
  double level;
};

/// The lines at all multiples of `distance`, in the unit of the colour, but 0, which is all of a free surface. The
/// field is the mean of the particles by a Gaussian as wide as their `spacing`, in the unit of x and y; where a node of
/// its grid has too few of them near, there are no lines. What is not finite counts as no particle. Nothing for a
/// distance or spacing that is not positive.
std::vector<IsolinePiece> isolines(const vnv::Cloud& cloud, double distance, double spacing);

}  // namespace touchstone::reports
