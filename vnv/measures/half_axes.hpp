#pragma once
#include "solvers/samples.hpp"

#include <array>

namespace touchstone::vnv {

/// Half-axes [m] of the ellipse of even density that has the second moments of all particles, the longer one first.
std::array<double, 2> half_axes(const Samples& samples);

}  // namespace touchstone::vnv
