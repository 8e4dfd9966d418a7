#pragma once
#include "solvers/mpm/shapes/shape_laws.hpp"

#include <array>

namespace touchstone::mpm {

/// The hat of the paper, bilinear in a cell (Sun et al., section 2.1; Sulsky, Chen & Schreyer 1994).
///
/// `X` and `Y` run from 0 to 1 over a cell, slopes are per cell, and corners are numbered (0,0), (1,0), (0,1), (1,1).
/// Within a cell the four weights are combinations of 1, X, Y and XY, which `at_corners` and `Within` spell out, so
/// that a cell is summed over its particles first and meets its corners once.
struct LinearHat {
  static constexpr int nodes = 2;  // along each direction
  static constexpr double place(int node) { return node; }
  static constexpr double weight(int node, double X) { return node == 0 ? 1 - X : X; }
  static constexpr double slope(int node, double) { return node == 0 ? -1 : 1; }

  template <class Q>
  using Corners = std::array<Q, 4>;

  /// Sums over the particles of a cell of q N_i, for its four corners, from those of q, q X, q Y and q XY.
  template <class Q>
  static constexpr Corners<Q> at_corners(const Q& q, const Q& qX, const Q& qY, const Q& qXY) {
    return {q - qX - qY + qXY, qX - qXY, qY - qXY, qXY};
  }

  /// Sums over the particles of a cell of q dN_i/dX, from those of q and q Y.
  template <class Q>
  static constexpr Corners<Q> slopes_along_X(const Q& q, const Q& qY) {
    return {qY - q, q - qY, -qY, qY};
  }
  /// Sums over the particles of a cell of q dN_i/dY, from those of q and q X.
  template <class Q>
  static constexpr Corners<Q> slopes_along_Y(const Q& q, const Q& qX) {
    return {qX - q, -qX, q - qX, qX};
  }

  /// The field sum q_i N_i within a cell: q0 + qX X + qY Y + qXY XY.
  template <class Q>
  struct Within {
    Q q0, qX, qY, qXY;

    constexpr Within() = default;
    constexpr Within(const Q& q00, const Q& q10, const Q& q01, const Q& q11)
        : q0(q00), qX(q10 - q00), qY(q01 - q00), qXY(q11 - q10 - qY) {}
    constexpr Q operator()(double X, double Y) const { return q0 + qX * X + (qY + qXY * X) * Y; }
  };
};

/// True if sums at the corners and fields within the cell are those of the weights.
constexpr bool corners_follow_the_weights() {
  constexpr double X = 0.25, Y = 0.625;
  const auto sums = LinearHat::at_corners<double>(1, X, Y, X * Y);
  const auto along_X = LinearHat::slopes_along_X(1.0, Y), along_Y = LinearHat::slopes_along_Y(1.0, X);
  for (int corner = 0; corner < 4; ++corner) {
    const int i = corner % 2, j = corner / 2;
    const double w = LinearHat::weight(i, X) * LinearHat::weight(j, Y);
    const LinearHat::Within<double> hat(corner == 0, corner == 1, corner == 2, corner == 3);
    if (sums[corner] != w || hat(X, Y) != w) return false;
    if (along_X[corner] != LinearHat::slope(i, X) * LinearHat::weight(j, Y)) return false;
    if (along_Y[corner] != LinearHat::weight(i, X) * LinearHat::slope(j, Y)) return false;
  }
  return true;
}

static_assert(obeys_shape_laws<LinearHat>());
static_assert(corners_follow_the_weights());

}  // namespace touchstone::mpm
