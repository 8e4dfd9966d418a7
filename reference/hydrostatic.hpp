#pragma once
#include "reference/refuse.hpp"

#include <cmath>

namespace touchstone::reference {

/// A fluid of Tait's law at rest under gravity, below a free surface at y = h: p = K ((rho / rho0)^gamma - 1) and
/// dp/dy = -rho g give (gamma / (gamma - 1)) K ((1 + p / K)^((gamma - 1) / gamma) - 1) = rho0 g (h - y). For a stiff
/// fluid it tends to rho0 g (h - y). Throws std::domain_error unless rho0, K, g and h are positive, gamma is above 1,
/// and y is at most h and finite.
struct Hydrostatic {
  double rho0;       // kg/m³  density without pressure
  double K;          // Pa     of Tait's law
  double g;          // m/s²   down, along -y
  double h;          // m      height of the surface
  double gamma = 7;  // -      of Tait's law

  /// Pressure [Pa].
  double p(double y) const {
    require_positive("Hydrostatic", {{"rho0 [kg/m³]", rho0}, {"K [Pa]", K}, {"g [m/s²]", g}, {"h [m]", h}});
    if (!(std::isfinite(gamma) && gamma > 1)) refuse("Hydrostatic", "gamma", gamma, "a finite number above 1");
    if (!(std::isfinite(y) && y <= h)) refuse("Hydrostatic", "y [m]", y, fmt::format("a finite place, at most {}", h));
    const double power = gamma / (gamma - 1);
    return K * std::expm1(power * std::log1p(rho0 * g * (h - y) / (power * K)));
  }

  /// Density [kg/m³].
  double rho(double y) const { return rho0 * std::exp(std::log1p(p(y) / K) / gamma); }

  /// Mass of a column from the floor at y = 0 to the surface, per area of its base [kg/m²].
  double mass() const { return p(0) / g; }
};

}  // namespace touchstone::reference
