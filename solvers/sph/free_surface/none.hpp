#pragma once
/// Neither diffusion of density nor shifting of particles: a method given these compiles none.

#include "solvers/forces/none.hpp"

namespace touchstone::sph {

struct NoDiffusion {};
struct NoShifting {};

}  // namespace touchstone::sph

template <>
inline constexpr bool touchstone::is_present<touchstone::sph::NoDiffusion> = false;
template <>
inline constexpr bool touchstone::is_present<touchstone::sph::NoShifting> = false;
