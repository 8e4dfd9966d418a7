#pragma once
#include "solvers/fields.hpp"

#include <cmath>

namespace touchstone {

/// A slightly compressible fluid without viscosity: P = K ((rho / rho0)^7 - 1).
/// Monaghan, J. Comput. Phys. 110 (1994), 399-406; Sun et al. (33).
struct Tait {
  double density;       // kg/m³  rho0, at rest and without pressure
  double bulk_modulus;  // Pa     K, a seventh of the true bulk modulus at rest

  static constexpr double gamma = 7;

  /// Pressure [Pa]; by four products, since `pow` would cost more than the rest of a step.
  template <class Real>
  constexpr Real pressure(const Real& rho) const {
    const Real z = rho * (1 / density);
    const Real z2 = z * z;
    const Real z3 = z2 * z;
    return bulk_modulus * (z3 * z3 * z - 1.0);
  }
  /// Density [kg/m³] at a pressure [Pa] above -K.
  double density_at(double pressure) const { return density * std::pow(1 + pressure / bulk_modulus, 1 / gamma); }
  /// dP / drho [m²/s²] at a density: the square of the speed of sound there.
  template <class Real>
  constexpr Real pressure_slope(const Real& rho) const {
    return gamma * (pressure(rho) + bulk_modulus) / rho;
  }
  /// Speed of sound at rest [m/s], sqrt(gamma K / rho0).
  double sound_speed() const { return std::sqrt(gamma * bulk_modulus / density); }
};

}  // namespace touchstone
