#pragma once
#include "reference/start_up.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace touchstone::reference {

/// Oscillating plane Poiseuille flow: v_x(y, t) [m/s] between plates at y = 0 and y = H of a fluid that has felt the
/// body force F cos(omega t) along x for ever; the start is not in it. The plane form of J. R. Womersley, J. Physiol.
/// 127 (1955), 553-563. Throws std::domain_error unless H, omega and nu are positive, F and t finite, y in
/// [0, H], and the Womersley number, half the gap over the height to which a wall is felt, at least 0.3: below, the two
/// parts of the profile cancel.
struct OscillatingPoiseuille {
  double H;      // m      gap
  double F;      // m/s²   largest body force per unit mass
  double omega;  // 1/s    angular frequency
  double nu;     // m²/s   kinematic viscosity

  /// The real part of F / (i omega) (1 - cosh(q (y - H/2)) / cosh(q H/2)) exp(i omega t) with q² = i omega / nu. Both
  /// hyperbolic cosines are taken relative to that of the wall, which may be too large for a double.
  double operator()(double y, double t) const {
    using Complex = std::complex<double>;
    require_positive("OscillatingPoiseuille", "omega [1/s]", omega);
    require_finite("OscillatingPoiseuille", "F [m/s²]", F);
    require_finite("OscillatingPoiseuille", "t [s]", t);
    const double place = scaled("OscillatingPoiseuille", y, 0, H, nu).y;
    const double womersley = H / 2 * std::sqrt(omega / nu);
    if (womersley < 0.3) refuse("OscillatingPoiseuille", "Womersley number", womersley, "at least 0.3");
    const Complex half = std::sqrt(Complex(0, 1)) * womersley;  // q H / 2
    const Complex up = std::exp(-2.0 * half * (1 - place)), down = std::exp(-2.0 * half * place);
    const Complex profile = 1.0 - (up + down) / (1.0 + std::exp(-2.0 * half));
    return F / omega * std::real(profile * Complex(0, -1) * std::polar(1.0, omega * t));
  }
};

}  // namespace touchstone::reference
