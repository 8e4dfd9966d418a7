#pragma once
#include "solvers/fluids/tait.hpp"

#include <algorithm>

namespace touchstone {

/// What a fluid without viscosity of its own holds under gravity [J/m].
struct Energy {
  double kinetic = 0, potential = 0, elastic = 0;

  double total() const { return kinetic + potential + elastic; }
};

/// What compression by Tait's law holds per mass [J/kg], the integral of P / rho² from rest to a density. Water that
/// has come apart bears no tension, and its density says nothing.
inline double elastic_energy(const Tait& fluid, double density) {
  const double z = std::max(density / fluid.density, 1.0), z3 = z * z * z;
  return fluid.bulk_modulus / fluid.density * (z3 * z3 / 6 + 1 / z - 7.0 / 6);
}

/// What each part of a method has added to the energy of its fluid since the start [J/m]: its own forces times the way
/// they went in each step, or what a change that is no force did. Together they are all of it, but for rounding.
struct EnergyBudget {
  Energy start, now;
  double pressure = 0;   // work on the fluid's motion, with the compression that answers it: what the two do not share
  double gravity = 0;    // likewise, with the height that is lost
  double viscosity = 0;  // of the method
  double smoothing = 0;  // of densities: their diffusion, or their way over the nodes with what bounds expansion there
  double walls = 0;      // what holds fluid at walls, but for pressure
  double transfer = 0;   // of velocities between particles and nodes
  double shifting = 0;   // of particles

  double parts() const { return pressure + gravity + viscosity + smoothing + walls + transfer + shifting; }
  /// What no part accounts for.
  double residual() const { return now.total() - start.total() - parts(); }
};

}  // namespace touchstone
