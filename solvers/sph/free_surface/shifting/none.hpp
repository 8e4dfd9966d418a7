#pragma once
/// No shifting of particles: a method given this compiles none into its step.

#include "solvers/forces/none.hpp"

namespace touchstone::sph {

struct NoShifting {};

}  // namespace touchstone::sph

template <>
inline constexpr bool touchstone::is_present<touchstone::sph::NoShifting> = false;
