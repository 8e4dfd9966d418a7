#pragma once
/// What bounds how far a signal travels in a step.

#include "solvers/integrators/fluid_state.hpp"

#include <cmath>

namespace touchstone {

/// Of all particles; where one is not a number, of the others.
struct Extremes {
  double speed;    // m/s    the greatest
  double density;  // kg/m³  the greatest
};

/// The fastest that anything travels through a fluid [m/s]: sound where it is densest, with its fastest particle.
template <class FluidLaw>
double signal_speed(const FluidLaw& fluid, const Extremes& of) {
  return std::sqrt(fluid.pressure_slope(of.density)) + of.speed;
}

inline Extremes extremes_of(const FluidState& all) {
  const auto part = Eigen::seqN(0, all.fluid);
  return {std::sqrt((all.vx(part).square() + all.vy(part).square()).maxCoeff()), all.rho(part).maxCoeff()};
}

}  // namespace touchstone
