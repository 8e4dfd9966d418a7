#pragma once
/// What cases of the manufactured solution share (vnv/flows/manufactured.cpp).

#include "solvers/forces/force_field.hpp"
#include "vnv/flows/flow.hpp"
#include "vnv/flows/squares/square.hpp"

namespace touchstone::vnv::manufactured {

inline constexpr double end = 0.2;  // s  a fifth of L / U
inline Scene<Newtonian, ForceField> scene() { return scene_of<Newtonian, ForceField>(flow_named("manufactured")); }

/// Of a transport velocity, which carries particles otherwise than the fluid moves: where the flow draws them apart
/// they are fewer than the fluid there, 5.0 spacings on the disturbed lattice with 34 across.
inline const Claim parted_by_transport =
    at_most(largest_hole, 7.5, baseline("1.5 times the first measured value: it does not move with the fluid")).at(end);

}  // namespace touchstone::vnv::manufactured
