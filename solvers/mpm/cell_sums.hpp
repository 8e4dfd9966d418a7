#pragma once
#include "solvers/mpm/particles.hpp"

namespace touchstone::mpm {

/// Sums over the particles of a cell of X^m Y^n, paired: how much the cell weighs, and where.
template <class Real>
struct CellMass {
  Pair<Real> X_Y = zero<Real>(), XX_YY = zero<Real>(), XXY_XYY = zero<Real>(), XY_XXYY = zero<Real>();

  void add(const Real& X, const Real& Y) {
    const Real XY = X * Y;
    X_Y += Pair<Real>{X, Y};
    XX_YY += Pair<Real>{X * X, Y * Y};
    XXY_XYY += Pair<Real>{X * XY, XY * Y};
    XY_XXYY += Pair<Real>{XY, XY * XY};
  }
  CellMass<double> total() const {
    return {mpm::total(X_Y), mpm::total(XX_YY), mpm::total(XXY_XYY), mpm::total(XY_XXYY)};
  }
};

/// Sums over the particles of a cell, per mass of a particle.
template <class FluidLaw, class Real>
struct CellSums {
  CellMass<Real> mass;
  Pair<Real> v = zero<Real>(), Xv = zero<Real>(), Yv = zero<Real>(), XYv = zero<Real>();  // m/s
  typename Stress<FluidLaw>::template Sums<Real> stress;

  void add(const Particles<FluidLaw>& particles, int slot) {
    const Real X = load<Real>(particles.X, slot), Y = load<Real>(particles.Y, slot);
    mass.add(X, Y);
    const Pair<Real> velocity{load<Real>(particles.vx, slot), load<Real>(particles.vy, slot)};
    v += velocity;
    Xv += X * velocity;
    Yv += Y * velocity;
    XYv += X * Y * velocity;
    stress.add(particles.stress, slot, load<Real>(particles.specific_volume, slot), X, Y);
  }
  CellSums<FluidLaw, double> total() const {
    return {mass.total(), mpm::total(v), mpm::total(Xv), mpm::total(Yv), mpm::total(XYv), stress.total()};
  }
};

template <class FluidLaw>
CellSums<FluidLaw, double> sum_over(const Particles<FluidLaw>& particles, int begin, int end) {
  CellSums<FluidLaw, double> sums;
  int slot = begin;
  if (end - begin >= lanes) {
    CellSums<FluidLaw, Lanes> wide;
    for (; slot + lanes <= end; slot += lanes) wide.add(particles, slot);
    sums = wide.total();
  }
  for (; slot < end; ++slot) sums.add(particles, slot);
  return sums;
}

}  // namespace touchstone::mpm
