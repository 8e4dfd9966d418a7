#pragma once
#include "reference/start_up.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace touchstone::reference {

/// Plane Poiseuille flow that swings: v_x(y, t) [m/s] between plates at y = 0 and y = H of a fluid that has felt the
/// body force F cos(omega t) along x for ever; the start is not in it. The plane form of J. R. Womersley, J. Physiol.
/// 127 (1955), 553-563. Throws std::domain_error unless H, omega and nu are positive, F and t finite, and y in [0, H].
struct OscillatingPoiseuille {
  double H;      // m      gap
  double F;      // m/s²   largest body force per unit mass
  double omega;  // 1/s    angular frequency
  double nu;     // m²/s   kinematic viscosity

  /// In closed form: the real part of F / (i omega) (1 - cosh(q (y - H/2)) / cosh(q H/2)) exp(i omega t) with q² =
  /// i omega / nu. Both hyperbolic cosines are taken relative to that of the wall, which may be too large for a double.
  /// Where the layers of the walls are many gaps thick it is a difference of almost equal numbers, and the series is
  /// taken.
  double operator()(double y, double t) const { return womersley() < 0.3 ? fourier(y, t) : closed(y, t); }

  double closed(double y, double t) const {
    using Complex = std::complex<double>;
    const double place = door(y, t);
    const Complex half = std::sqrt(Complex(0, 1)) * womersley();  // q H / 2
    const Complex up = std::exp(-2.0 * half * (1 - place)), down = std::exp(-2.0 * half * place);
    const Complex profile = 1.0 - (up + down) / (1.0 + std::exp(-2.0 * half));
    return F / omega * std::real(profile * Complex(0, -1) * std::polar(1.0, omega * t));
  }

  /// As the parabola that would be steady under the force of the moment, and a sum of sines that lag behind it.
  /// Bound: with k = n pi and r = omega H² / (nu k²), a lag is at most r, and a term at most 4 r / k³; in units of
  /// F H² / (8 nu) the odd terms from n on hold less than 36 omega H² / (nu pi^5 n^4).
  double fourier(double y, double t) const {
    const double place = door(y, t), swing = omega * H * H / nu;
    const auto lag = [&](double n) {
      const double k = n * std::numbers::pi, r = swing / (k * k);
      return std::sin(k * place) / (k * k * k) * r * (std::sin(omega * t) - r * std::cos(omega * t)) / (1 + r * r);
    };
    const auto rest = [&](double n) { return 36 * swing / (std::pow(std::numbers::pi, 5) * std::pow(n, 4)); };
    return F * H * H / nu * (std::cos(omega * t) * place * (1 - place) / 2 + 4 * sum(1, 2, lag, rest));
  }

  /// Half the gap over the height to which a wall is felt, H / 2 sqrt(omega / nu).
  double womersley() const { return H / 2 * std::sqrt(omega / nu); }

 private:
  double door(double y, double t) const {
    require_positive("OscillatingPoiseuille", "omega [1/s]", omega);
    require_finite("OscillatingPoiseuille", "F [m/s²]", F);
    require_finite("OscillatingPoiseuille", "t [s]", t);
    return scaled("OscillatingPoiseuille", y, 0, H, nu).y;
  }
};

}  // namespace touchstone::reference
