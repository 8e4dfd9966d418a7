#pragma once
#include "solvers/samples.hpp"

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>

namespace touchstone::vnv {

/// Half-axes [m] of the ellipse of even density that has the second moments of all particles, the longer one first.
inline std::array<double, 2> half_axes(const Samples& samples) {
  const double mass = samples.mass.sum();
  const Vec2 centre = samples.x * samples.mass.matrix() / mass;
  const Vectors from = samples.x.colwise() - centre;
  const Mat2 moments = from * samples.mass.matrix().asDiagonal() * from.transpose() / mass;
  const Vec2 along = Eigen::SelfAdjointEigenSolver<Mat2>(moments).eigenvalues();  // rising
  return {2 * std::sqrt(along[1]), 2 * std::sqrt(along[0])};
}

}  // namespace touchstone::vnv
