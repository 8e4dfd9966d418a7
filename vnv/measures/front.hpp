#pragma once
/// Where the front of a dam break is that runs along a floor in +x, and how high water stands. The answer depends on
/// the operator, so there are four: log all, judge `half_full_slab`. Each gives x [m]; without a front, or with a place
/// or volume that is not a finite number, it gives not a number.

#include "solvers/samples.hpp"

namespace touchstone::vnv {

namespace fronts {

/// False where a place or a volume is not a number, or a volume not positive.
bool known(const Samples& samples);

}  // namespace fronts

/// The particle that is farthest along x: one drop of spray moves it.
double farthest_particle(const Samples& samples);

/// The rearmost particle for which it and those behind it hold at least 99.5 % of the volume.
double percentile_front(const Samples& samples);

/// The farthest particle of the body of most particles: those closer than `reach` [m] to one of a body belong to it.
double farthest_of_body(const Samples& samples, double reach);

/// The volume [m²] of the water behind x [m], of particles that are squares: one that stands across counts by its part.
/// Over a length from a wall on it is the mean height there.
double volume_behind(const Samples& samples, double x);

/// The middle of the farthest slab that is half full: one cell [m] long, one cell high, standing on the floor, anywhere
/// along x, and full when the fluid in it has the volume cell².
///
/// A particle of volume V is an upright square of side sqrt(V), of which the part below the top of the slab counts, so
/// the slab that is exactly half full is found by moving one backwards from the farthest fluid. An upright face at
/// least a cell high is found where it stands, whatever the spacing. A sheet thinner than half a cell, or drops that
/// together fill no half slab, are no front; with one particle a cell, a lone particle on the floor is one.
/// Throws std::invalid_argument for a cell that is not positive.
double half_full_slab(const Samples& samples, double cell);

}  // namespace touchstone::vnv
