#pragma once
#include "solvers/mpm/printed/particles.hpp"

namespace touchstone::mpm {

/// Sums over the particles of a cell of X^m Y^n: how much the cell weighs, and where.
template <class Real>
struct CellMass {
  Real one{}, X{}, Y{}, XX{}, YY{}, XY{}, XXY{}, XYY{}, XXYY{};

  static CellMass at(const Real& x, const Real& y) {
    const Real xy = x * y;
    return {Real{}, x, y, x * x, y * y, xy, x * xy, xy * y, xy * xy};
  }
  CellMass& operator+=(const CellMass& other) {
    X += other.X;
    Y += other.Y;
    XX += other.XX;
    YY += other.YY;
    XY += other.XY;
    XXY += other.XXY;
    XYY += other.XYY;
    XXYY += other.XXYY;
    return *this;
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

  static Moments of(const Real& q, const Real& x, const Real& y, const Real& xy) { return {q, x * q, y * q, xy * q}; }
  Moments& operator+=(const Moments& other) {
    one += other.one;
    X += other.X;
    Y += other.Y;
    XY += other.XY;
    return *this;
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

/// Sums over the particles of a cell of their momenta, per mass of a particle [m/s].
template <class Real>
struct Momentum {
  Moments<Real> x, y;

  Momentum& operator+=(const Momentum& other) {
    x += other.x;
    y += other.y;
    return *this;
  }
};

/// What `terms_at(slot)` says of the particles of a block, summed, one cell a lane.
template <class Number, class Block, class TermsAt>
auto sum_over(const Block& block, const TermsAt& terms_at) {
  auto sums = terms_at(block.first);
  const int end = block.slot(0, block.most());
  for (int slot = block.first + lanes_of<Number>; slot < end; slot += lanes_of<Number>) sums += terms_at(slot);
  return sums;
}

// Each of these has a loop of its own, so that its sums stay in registers.

template <class Number, class FluidLaw, class Block, class Real = LanesOf<Number>>
CellMass<Real> mass_of(const Particles<FluidLaw, Number>& particles, const Block& block) {
  auto sums = sum_over<Number>(block, [&](int slot) {
    return CellMass<Real>::at(load<Real>(&particles.X[slot]), load<Real>(&particles.Y[slot]));
  });
  sums.one = converted<Real>(block.count.data());
  return sums;
}

template <class Number, class FluidLaw, class Block, class Real = LanesOf<Number>>
Momentum<Real> momentum_of(const Particles<FluidLaw, Number>& particles, const Block& block) {
  return sum_over<Number>(block, [&](int slot) {
    const Real X = load<Real>(&particles.X[slot]), Y = load<Real>(&particles.Y[slot]), XY = X * Y;
    return Momentum<Real>{Moments<Real>::of(load<Real>(&particles.vx[slot]), X, Y, XY),
                          Moments<Real>::of(load<Real>(&particles.vy[slot]), X, Y, XY)};
  });
}

template <class Number, class FluidLaw, class Block, class Real = LanesOf<Number>>
auto stress_of(const Particles<FluidLaw, Number>& particles, const Block& block) {
  return sum_over<Number>(block, [&](int slot) {
    return particles.stress.template terms_at<Real>(slot, load<Real>(&particles.X[slot]),
                                                    load<Real>(&particles.Y[slot]));
  });
}

}  // namespace touchstone::mpm
