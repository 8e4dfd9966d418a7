#pragma once
#include "reference/refuse.hpp"

#include <cmath>
#include <numbers>

namespace touchstone::reference {

/// Decaying Taylor-Green vortices: velocity [m/s] and pressure [Pa] of an incompressible fluid in a square of side L,
/// periodic along both axes, with 2 x 2 vortices of top speed U at t = 0. G. I. Taylor, Phil. Mag. 46 (1923), 671-674.
/// The Reynolds number of the literature is U L / nu. The pressure is that of zero mean.
/// Throws std::domain_error unless L, rho and nu are positive, U, x and y finite, and t finite and not negative.
struct TaylorGreen {
  double L;    // m      period along x and y
  double U;    // m/s    top speed at the start
  double nu;   // m²/s   kinematic viscosity
  double rho;  // kg/m³

  double v_x(double x, double y, double t) const { return -U * decay(x, y, t) * std::cos(k() * x) * std::sin(k() * y); }
  double v_y(double x, double y, double t) const { return U * decay(x, y, t) * std::sin(k() * x) * std::cos(k() * y); }
  double p(double x, double y, double t) const {
    const double now = U * decay(x, y, t);
    return -rho * now * now / 4 * (std::cos(2 * k() * x) + std::cos(2 * k() * y));
  }

  /// How fast velocities fall [1/s]: as exp(-rate t); energy falls twice as fast.
  double decay_rate() const { return 2 * nu * k() * k(); }
  /// Mean kinetic energy per volume [J/m³].
  double energy(double t) const {
    const double now = U * decay(0, 0, t);
    return rho * now * now / 4;
  }

 private:
  double k() const { return 2 * std::numbers::pi / L; }
  double decay(double x, double y, double t) const {
    require_positive("TaylorGreen", {{"L [m]", L}, {"nu [m²/s]", nu}, {"rho [kg/m³]", rho}});
    require_finite("TaylorGreen", {{"U [m/s]", U}, {"x [m]", x}, {"y [m]", y}});
    require_time("TaylorGreen", t);
    return std::exp(-decay_rate() * t);
  }
};

}  // namespace touchstone::reference
