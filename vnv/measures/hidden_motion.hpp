#pragma once
/// What of the particles' motion the method cannot see.

#include "solvers/samples.hpp"

namespace touchstone::vnv {

/// Root mean square of what is left of the particles' velocities after a linear fit around each of them, to the
/// particles within `reach` [m], over that of the velocities: motion of one particle against the next. Modes of it in
/// which the nodes of the material point method see nothing live on for ever (null-space modes). For up to some
/// thousand particles: each is compared with all.
double hidden_motion(const Samples& s, double reach);

/// The distance of the closest two particles [m]: in smoothed particle hydrodynamics they pair where the kernel's slope
/// no longer pushes them apart (tensile or pairing instability). Infinite for fewer than two.
double closest_pair(const Samples& s);

}  // namespace touchstone::vnv
