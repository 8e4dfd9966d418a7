#pragma once
#include "solvers/samples.hpp"

#include <array>
#include <cmath>

namespace touchstone::vnv {

/// Half-axes [m] of the ellipse of even density that has the second moments of all particles, the longer one first.
inline std::array<double, 2> half_axes(const Samples& samples) {
  const double mass = samples.mass.sum();
  const Vec2 centre = samples.x * samples.mass.matrix() / mass;
  const Vectors from = samples.x.colwise() - centre;
  const Mat2 moments = from * samples.mass.matrix().asDiagonal() * from.transpose() / mass;
  const double middle = moments.trace() / 2, half = std::hypot((moments(0, 0) - moments(1, 1)) / 2, moments(0, 1));
  return {2 * std::sqrt(middle + half), 2 * std::sqrt(middle - half)};
}

}  // namespace touchstone::vnv
