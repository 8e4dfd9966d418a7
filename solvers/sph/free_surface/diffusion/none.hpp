#pragma once
/// No diffusion of density: a method given this compiles none into its sums.

#include "solvers/forces/none.hpp"

namespace touchstone::sph {

struct NoDiffusion {};

}  // namespace touchstone::sph

template <>
inline constexpr bool touchstone::is_present<touchstone::sph::NoDiffusion> = false;
