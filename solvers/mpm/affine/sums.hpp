#pragma once
#include "solvers/mpm/affine/particles.hpp"
#include "solvers/mpm/nodes_of_cells.hpp"
#include "solvers/mpm/shapes/quadratic_b_spline.hpp"

namespace touchstone::mpm {

/// Sums over the particles of the cells of a block, one cell a lane, of products of the three functions of X and of Y
/// of which the weights are made. Slots without a particle, at X = Y = 0, add nothing to sums of powers.
template <class Number, class Block, class Real = LanesOf<Number>>
ThreeByThree<Real> mass_of(const AffineParticles<Number>& particles, const Block& block) {
  const Real one = converted<Real>(block.count.data());
  Real X{}, XX{}, Y{}, XY{}, XXY{}, YY{}, XYY{}, XXYY{};
  const int end = block.slot(0, block.most());
  for (int slot = block.first; slot < end; slot += lanes_of<Number>) {
    const Real x = load<Real>(&particles.X[slot]), y = load<Real>(&particles.Y[slot]), xx = x * x, yy = y * y;
    X += x;
    XX += xx;
    Y += y;
    XY += x * y;
    XXY += xx * y;
    YY += yy;
    XYY += x * yy;
    XXYY += xx * yy;
  }
  const auto of_powers = QuadraticBSpline::of_powers<Real>;
  const auto of_one = of_powers(one, X, XX), of_Y = of_powers(Y, XY, XXY), of_YY = of_powers(YY, XYY, XXYY);
  ThreeByThree<Real> sums;
  for (int m = 0; m < 3; ++m) sums[m] = of_powers(of_one[m], of_Y[m], of_YY[m]);
  return sums;
}

/// The same of weights times what the particles give to the nodes, for one component of the velocity [m/s].
template <class Number, class Block, class Real = LanesOf<Number>>
ThreeByThree<Real> momentum_of(const AffineParticles<Number>& particles,
                               const typename AffineParticles<Number>::Component& component, const Block& block) {
  ThreeByThree<Real> sums{};
  const int end = block.slot(0, block.most());
  for (int slot = block.first; slot < end; slot += lanes_of<Number>) {
    const QuadraticBSpline::Basis<Real> X(load<Real>(&particles.X[slot])), Y(load<Real>(&particles.Y[slot]));
    const Real v = load<Real>(&component.v[slot]), along_x = load<Real>(&component.along_x[slot]),
               along_y = load<Real>(&component.along_y[slot]);
    const auto add = [&](std::array<Real, 3>& to, const Real& weighted, const Real& turned) {
      to[0] += weighted;
      to[1] += weighted * Y.xi + turned;
      to[2] += weighted * Y.even + turned * Y.lever;
    };
    add(sums[0], v, along_y);
    add(sums[1], v * X.xi + along_x, along_y * X.xi);
    add(sums[2], v * X.even + along_x * X.lever, along_y * X.even);
  }
  return sums;
}

template <int part, class Real>
ThreeByThree<Lanes> widened(const ThreeByThree<Real>& sums) {
  ThreeByThree<Lanes> wide;
  for (int m = 0; m < 3; ++m)
    for (int n = 0; n < 3; ++n) wide[m][n] = widened<part>(sums[m][n]);
  return wide;
}

/// What the nine nodes get, by column and row.
inline ThreeByThree<Lanes> at_nodes(const ThreeByThree<Lanes>& sums) {
  ThreeByThree<Lanes> nodes;
  std::array<std::array<Lanes, 3>, 3> by_column;  // of each function of Y
  for (int n = 0; n < 3; ++n) by_column[n] = QuadraticBSpline::at_nodes(sums[0][n], sums[1][n], sums[2][n]);
  for (int a = 0; a < 3; ++a) nodes[a] = QuadraticBSpline::at_nodes(by_column[0][a], by_column[1][a], by_column[2][a]);
  return nodes;
}

}  // namespace touchstone::mpm
