#pragma once
/// The parts that methods are made of, on a resting lattice: each in the place of one part of a method that is always
/// the same, so that one sees what it does to the largest stable step.

#include "vnv/stability/methods_on_lattice.hpp"

namespace touchstone::vnv {

/// In MPM, of linear hats, FLIP, MUSL and carried densities; in SPH, of delta-SPH with Wendland's C2 kernel and
/// kick-drift-kick. Parts that do nothing at rest, walls, viscosities and shifting, are not here.
std::vector<LatticeMethod> parts_on_lattice();

}  // namespace touchstone::vnv
