#pragma once
/// Sums over the particles of cells. Those of q X^i Y^j stand at [i][j].

#include "solvers/mpm/printed/particles.hpp"
#include "solvers/mpm/shapes/linear_hat.hpp"

namespace touchstone::mpm {

/// How much a cell weighs, and where: q = 1.
template <class Real>
using CellMass = Square<Real, 3>;
/// Of any q.
template <class Real>
using Moments = Square<Real, 2>;
/// Of both components of a vector.
template <class Real>
using VectorMoments = std::array<Moments<Real>, 2>;
/// Of the stress on each axis, by the axis along which it acts: its sum, and that with the coordinate across.
template <class Real>
using StressMoments = Square<std::array<Real, 2>, 2>;

template <class Real>
Moments<Real> moments(const Real& q, const Real& X, const Real& Y) {
  const Real XY = X * Y;
  return {{{q, Y * q}, {X * q, XY * q}}};
}

template <class Real>
void add_to(Real& sum, const Real& term) {
  sum += term;
}
template <class Part, std::size_t count>
void add_to(std::array<Part, count>& sums, const std::array<Part, count>& terms) {
  for_indices<static_cast<int>(count)>([&](auto k) { add_to(sums[k], terms[k]); });
}
template <int part, class Part, std::size_t count>
auto widened(const std::array<Part, count>& sums) {
  return with_indices<static_cast<int>(count)>([&](auto... k) { return std::array{widened<part>(sums[k])...}; });
}

/// What `terms_at(slot)` says of the particles of a block, summed, one cell a lane.
template <class Number, class Block, class TermsAt>
auto sum_over(const Block& block, const TermsAt& terms_at) {
  auto sums = terms_at(block.first);
  const int end = block.slot(0, block.most());
  for (int slot = block.first + lanes_of<Number>; slot < end; slot += lanes_of<Number>) add_to(sums, terms_at(slot));
  return sums;
}

// Each of these has a loop of its own, so that its sums stay in registers.

template <class Number, class FluidLaw, class Block, class Real = LanesOf<Number>>
CellMass<Real> mass_of(const PrintedParticles<FluidLaw, Number>& particles, const Block& block) {
  auto sums = sum_over<Number>(block, [&](int slot) -> CellMass<Real> {
    const Real X = load<Real>(&particles.X[slot]), Y = load<Real>(&particles.Y[slot]), XY = X * Y;
    return {{{Real{}, Y, Y * Y}, {X, XY, XY * Y}, {X * X, X * XY, XY * XY}}};
  });
  sums[0][0] = converted<Real>(block.count.data());
  return sums;
}

/// Per mass of a particle [m/s].
template <class Number, class FluidLaw, class Block, class Real = LanesOf<Number>>
VectorMoments<Real> momentum_of(const PrintedParticles<FluidLaw, Number>& particles, const Block& block) {
  return sum_over<Number>(block, [&](int slot) -> VectorMoments<Real> {
    const Real X = load<Real>(&particles.X[slot]), Y = load<Real>(&particles.Y[slot]);
    return {moments(load<Real>(&particles.vx[slot]), X, Y), moments(load<Real>(&particles.vy[slot]), X, Y)};
  });
}

/// Only what there is: a pressure acts along its own axis.
template <class Number, class FluidLaw, class Block, class Real = LanesOf<Number>>
StressMoments<Real> stress_of(const PrintedParticles<FluidLaw, Number>& particles, const Block& block) {
  return sum_over<Number>(block, [&](int slot) {
    const std::array<Real, 2> across{load<Real>(&particles.Y[slot]), load<Real>(&particles.X[slot])};
    StressMoments<Real> terms{};
    for_indices<2>([&](auto axis) {
      for_indices<2>([&](auto along) {
        if constexpr (axis != along && !Viscous<FluidLaw>) return;
        const Real stress = particles.stress.template of<Real>(axis, along, slot);
        terms[axis][along] = {stress, across[along] * stress};
      });
    });
    return terms;
  });
}

/// Forces on the four corners of a cell along both axes.
using CornerForces = std::array<LinearHat::Corners<Lanes>, 2>;

/// Internal ones (12); `per_cell` [1/m] is 1 / the size of a cell.
template <class FluidLaw>
CornerForces forces_of(const StressMoments<Lanes>& stress, const Vec2& per_cell) {
  const auto along_x = [&](const std::array<Lanes, 2>& sum) {
    return LinearHat::slopes_along_X<Lanes>(-per_cell.x() * sum[0], -per_cell.x() * sum[1]);
  };
  const auto along_y = [&](const std::array<Lanes, 2>& sum) {
    return LinearHat::slopes_along_Y<Lanes>(-per_cell.y() * sum[0], -per_cell.y() * sum[1]);
  };
  if constexpr (!Viscous<FluidLaw>) return {along_x(stress[0][0]), along_y(stress[1][1])};
  CornerForces forces{along_x(stress[0][0]), along_x(stress[1][0])};
  for_indices<2>([&](auto axis) { add_to(forces[axis], along_y(stress[axis][1])); });
  return forces;
}

}  // namespace touchstone::mpm
