#pragma once
/// Linear stability of a method as it is implemented (von Neumann analysis, by numbers).

#include "vnv/stability/resting_lattice.hpp"

namespace touchstone::vnv {

/// What grows fastest of small disturbances of a lattice at rest.
struct Spectrum {
  double radius;  // -  growth factor per step: the spectral radius of the linearised step, over all waves
  Vec2 wave;      // its wave number, in half turns from one unit cell to the next: (1, 1) is the shortest
};

/// The step of a method, linearised about rest on a lattice and taken apart into the waves that fit it, in steps in
/// which sound travels `courant` unit cells.
///
/// The method is asked, not copied: place, velocity and density of each particle of one unit cell are disturbed by less
/// than a millionth, forth and back, and simulated for some steps. What that does to all particles, transformed over
/// the unit cells, is for each wave a sequence of matrices C A^n B, with A the step on that wave. Its eigenvalues are
/// those of the smallest A that has the sequence (Ho & Kalman 1966, by singular values of its Hankel matrix): so what a
/// method remembers from step to step without showing it, affine velocities or past rates, is taken into account. The
/// first steps, in which methods of several steps start otherwise, are left out. Velocities and densities are
/// evaluated; what only moves particles about, as a drift that packs them otherwise than squarely, changes no flow and
/// is not counted. What a method does only every so many steps, as to reinitialise its densities, is seen where that
/// many, `every`, are taken for one.
Spectrum spectrum(const OnLattice& method, const RestingLattice& lattice, double courant, int every = 1);

/// From this growth factor on a disturbance is said to grow: a trial of two thousand steps shows no slower growth.
inline constexpr double growing = 1.005;

/// The Courant number, of unit cells, beyond which disturbances grow, by bisection to a five-hundredth. Throws
/// std::invalid_argument if they grow at `low` or do not at `high`.
double critical_courant(const OnLattice& method, const RestingLattice& lattice, int every = 1, double low = 0.1,
                        double high = 8);

}  // namespace touchstone::vnv
