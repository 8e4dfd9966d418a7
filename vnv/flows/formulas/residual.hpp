#pragma once
/// Whether the exact fields of a flow solve the equations that it is said to obey.

#include "vnv/flows/flow.hpp"

#include <string>

namespace touchstone::vnv::formulas {

/// Beyond it formulas do not solve an equation: differences leave 1e-6 or less.
inline constexpr double largest_residual = 1e-3;

struct Residual {
  double size;           // over the largest term of its equation
  std::string sentence;  // which equation, and where that is
};

/// The largest residual of the continuity equation and of the Navier-Stokes equations of an incompressible fluid, at
/// places within the domain and the times of the flow, by central differences of sixth order; without an exact pressure
/// of the curl of the latter. Throws std::invalid_argument where the fields hold no numbers.
Residual residual_of(const Flow& flow);

}  // namespace touchstone::vnv::formulas
