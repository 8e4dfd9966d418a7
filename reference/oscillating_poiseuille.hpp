#pragma once
#include "reference/start_up.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace touchstone::reference {

/// Oscillating plane Poiseuille flow: v_x(y, t) [m/s] between plates at y = 0 and y = H of a fluid that has felt the
/// body force F cos(omega t) along x for ever; the start is not in it. The plane form of J. R. Womersley, J. Physiol.
/// 127 (1955), 553-563. Throws std::domain_error unless H, omega and nu are positive, F and t finite, and y in [0, H].
struct OscillatingPoiseuille {
  double H;      // m      gap
  double F;      // m/s²   largest body force per unit mass
  double omega;  // 1/s    angular frequency
  double nu;     // m²/s   kinematic viscosity

  /// The real part of F / (i omega) (1 - cosh(q (y - H/2)) / cosh(q H/2)) exp(i omega t) with q² = i omega / nu. The
  /// difference is 2 sinh(q y/2) sinh(q (H - y)/2) / cosh(q H/2), in which nothing cancels where the gap is much less
  /// than the height to which a wall is felt; each factor is taken over its exponential, which may be too large for a
  /// double.
  double operator()(double y, double t) const {
    using Complex = std::complex<double>;
    require_positive("OscillatingPoiseuille", {{"omega [1/s]", omega}});
    require_finite("OscillatingPoiseuille", {{"F [m/s²]", F}, {"t [s]", t}});
    const double place = scaled("OscillatingPoiseuille", y, 0, H, nu).y;
    const Complex half = std::sqrt(Complex(0, 1)) * (H / 2 * std::sqrt(omega / nu));  // q H / 2, by Womersley's number
    const auto part = [](const Complex& z) {
      return z.real() < 1 ? 2.0 * std::exp(-z) * std::sinh(z) : 1.0 - std::exp(-2.0 * z);
    };
    const Complex profile = part(half * place) * part(half * (1 - place)) / (1.0 + std::exp(-2.0 * half));
    return F / omega * std::real(profile * Complex(0, -1) * std::polar(1.0, omega * t));
  }
};

}  // namespace touchstone::reference
