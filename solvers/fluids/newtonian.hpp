#pragma once
#include "solvers/fluids/tait.hpp"

namespace touchstone {

/// A slightly compressible fluid with Newtonian viscosity, Sun et al. (32):
/// sigma = 2 mu eps - (2/3) mu tr(eps) I - P I, with eps the rate of strain and P from `Tait` (33).
struct Newtonian : Tait {
  double viscosity;  // Pa s  mu

  double kinematic_viscosity() const { return viscosity / density; }  // m²/s
};

template <class FluidLaw>
concept Viscous = requires(const FluidLaw& fluid) {
  fluid.viscosity;
};

}  // namespace touchstone
