#pragma once
#include "solvers/mpm/particles.hpp"

namespace touchstone::mpm {

/// Sums over the particles of a cell of X^m Y^n: how much the cell weighs, and where.
template <class Real>
struct CellMass {
  Real one{}, X{}, Y{}, XX{}, YY{}, XY{}, XXY{}, XYY{}, XXYY{};

  void add(const Real& x, const Real& y) {
    const Real xy = x * y;
    X += x;
    Y += y;
    XX += x * x;
    YY += y * y;
    XY += xy;
    XXY += x * xy;
    XYY += xy * y;
    XXYY += xy * xy;
  }
};
template <int part, class Real>
CellMass<Lanes> widened(const CellMass<Real>& m) {
  return {widened<part>(m.one), widened<part>(m.X),   widened<part>(m.Y),   widened<part>(m.XX),  widened<part>(m.YY),
          widened<part>(m.XY),  widened<part>(m.XXY), widened<part>(m.XYY), widened<part>(m.XXYY)};
}

/// Sums over the particles of a cell of q, q X, q Y and q XY.
template <class Real>
struct Moments {
  Real one{}, X{}, Y{}, XY{};

  void add(const Real& q, const Real& x, const Real& y, const Real& xy) {
    one += q;
    X += x * q;
    Y += y * q;
    XY += xy * q;
  }
  template <class Number>
  void set(int lane, const Moments<Number>& of_lane) {
    one[lane] = of_lane.one;
    X[lane] = of_lane.X;
    Y[lane] = of_lane.Y;
    XY[lane] = of_lane.XY;
  }
};
template <int part, class Real>
Moments<Lanes> widened(const Moments<Real>& m) {
  return {widened<part>(m.one), widened<part>(m.X), widened<part>(m.Y), widened<part>(m.XY)};
}

/// Sums over the particles of the cells of a block, one cell a lane, per mass of a particle. Each has a loop of its
/// own, so that its sums stay in registers.
template <class Number, class FluidLaw, class Block, class Real = LanesOf<Number>>
CellMass<Real> mass_of(const Particles<FluidLaw, Number>& particles, const Block& block) {
  CellMass<Real> sums;
  for (std::size_t lane = 0; lane < block.count.size(); ++lane) sums.one[lane] = static_cast<Number>(block.count[lane]);
  const int end = block.slot(0, block.most());
  for (int slot = block.first; slot < end; slot += lanes_of<Number>)
    sums.add(load<Real>(&particles.X[slot]), load<Real>(&particles.Y[slot]));
  return sums;
}

template <class Real>
struct Momentum {
  Moments<Real> x, y;  // m/s
};

template <class Number, class FluidLaw, class Block, class Real = LanesOf<Number>>
Momentum<Real> momentum_of(const Particles<FluidLaw, Number>& particles, const Block& block) {
  Momentum<Real> sums;
  const int end = block.slot(0, block.most());
  for (int slot = block.first; slot < end; slot += lanes_of<Number>) {
    const Real X = load<Real>(&particles.X[slot]), Y = load<Real>(&particles.Y[slot]), XY = X * Y;
    sums.x.add(load<Real>(&particles.vx[slot]), X, Y, XY);
    sums.y.add(load<Real>(&particles.vy[slot]), X, Y, XY);
  }
  return sums;
}

template <class Number, class FluidLaw, class Block, class Real = LanesOf<Number>>
auto stress_of(const Particles<FluidLaw, Number>& particles, const Block& block) {
  typename Stress<FluidLaw, Number>::template Sums<Real> sums;
  const int end = block.slot(0, block.most());
  for (int slot = block.first; slot < end; slot += lanes_of<Number>)
    sums.add(particles.stress, slot, load<Real>(&particles.X[slot]), load<Real>(&particles.Y[slot]));
  return sums;
}

}  // namespace touchstone::mpm
