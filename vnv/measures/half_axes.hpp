#pragma once
#include "solvers/samples.hpp"

namespace touchstone::vnv {

struct HalfAxes {
  double longer, shorter;  // m
};

/// Of the ellipse of even density that has the second moments of all particles.
HalfAxes half_axes(const Samples& samples);

}  // namespace touchstone::vnv
