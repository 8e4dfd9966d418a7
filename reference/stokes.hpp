#pragma once
/// Stokes' two problems: a fluid above a plate at y = 0 that moves along itself. G. G. Stokes, Trans. Camb. Phil. Soc.
/// 9 (1851), part II, 8-106; H. Schlichting, Boundary-Layer Theory (1979), chapter V.

#include "reference/start_up.hpp"

#include <cmath>

namespace touchstone::reference {

/// The first: v_x(y, t) [m/s] of a fluid at rest whose plate moves with V from t = 0 on. At t = 0 the fluid at the
/// plate already has its velocity. Throws std::domain_error unless nu is positive, V finite, y finite and not negative,
/// and t finite and not negative.
struct StokesFirst {
  double V;   // m/s   velocity of the plate
  double nu;  // m²/s  kinematic viscosity

  double operator()(double y, double t) const {
    require_positive("StokesFirst", {{"nu [m²/s]", nu}});
    require_finite("StokesFirst", {{"V [m/s]", V}});
    require_time("StokesFirst", t);
    require_height("StokesFirst", y);
    if (y == 0) return V;
    const double layer = 2 * std::sqrt(nu * t);
    return layer > 0 ? V * erfc(y / layer) : 0;
  }
};

/// The second: v_x(y, t) [m/s] above a plate that has swung with V cos(omega t) for ever; the start is not in it.
/// Throws std::domain_error unless omega and nu are positive, V and t finite, and y finite and not negative.
struct StokesSecond {
  double V;      // m/s    largest velocity of the plate
  double omega;  // 1/s    angular frequency
  double nu;     // m²/s   kinematic viscosity

  double operator()(double y, double t) const {
    require_positive("StokesSecond", {{"omega [1/s]", omega}, {"nu [m²/s]", nu}});
    require_finite("StokesSecond", {{"V [m/s]", V}, {"t [s]", t}});
    require_height("StokesSecond", y);
    return V * std::exp(-y / layer()) * std::cos(omega * t - y / layer());
  }

  /// Height over which the motion falls to a part in e [m].
  double layer() const { return std::sqrt(2 * nu / omega); }
};

}  // namespace touchstone::reference
