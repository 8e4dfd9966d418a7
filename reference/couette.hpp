#pragma once
#include "reference/start_up.hpp"

#include <cmath>
#include <numbers>

namespace touchstone::reference {

/// Start-up of plane Couette flow: v_x(y, t) [m/s] of a fluid at rest between a plate at y = 0 that stays and a plate
/// at y = H that moves with V along +x from t = 0. Morris, Fox & Zhu, J. Comput. Phys. 136 (1997), 214-226. At t = 0
/// the fluid at y = H already has the velocity of the plate, as at every later time; all other fluid rests. Sun et al.
/// (37) prints its sum from n = 0, whose term is 0 / 0; it starts at n = 1. Its centreline values for 0.8 and 1 s,
/// 0.04997 and 0.04999 mm/s, are cut off and not rounded. Throws std::domain_error unless H and nu are positive, V is
/// finite, y is in [0, H] and t is finite and not negative.
struct Couette {
  double H;   // m     gap
  double V;   // m/s   velocity of the upper plate
  double nu;  // m²/s  kinematic viscosity

  /// By the representation that is cheaper at this time; the two cost the same at nu t / H² = 0.03 (measured).
  double operator()(double y, double t) const { return nu / H * (t / H) < 0.03 ? images(y, t) : fourier(y, t); }

  /// The series (37) from n = 1, for late times: refused for nu t / H² below 1e-7.
  /// Bound: with a = pi² nu t / H², the sum of exp(-m² a) / m from m = n on is less than its first term and the
  /// integral over m of exp(-m² a) m / n² behind it, together exp(-n² a) (1 / n + 1 / (2 a n²)).
  double fourier(double y, double t) const {
    const Scaled at = door(y, t);
    require_fourier("Couette::fourier", at.t);
    const double a = std::numbers::pi * std::numbers::pi * at.t;
    const auto decay = [&](double n) { return 2 * std::numbers::inv_pi * std::exp(-n * n * a); };
    const auto wave = [&](double n) {
      const double sign = std::fmod(n, 2) == 0 ? 1 : -1;
      return sign * std::sin(n * std::numbers::pi * at.y) / n * decay(n);
    };
    const auto rest = [&](double n) { return decay(n) * (1 / n + 1 / (2 * a * n * n)); };
    return V * (at.y + sum(1, 1, wave, rest));
  }

  /// The layer of the moving plate and its images, for early times: refused for nu t / H² above 10.
  /// Carslaw & Jaeger, Conduction of Heat in Solids (1959), Laplace transform in powers of exp(-q H).
  /// Bound: the erfc alternate in sign and fall, so from the n-th pair on they hold at most its first, which is at most
  /// erfc(2 n H / sqrt(4 nu t)) <= exp(-n² H² / (nu t)).
  double images(double y, double t) const {
    const Scaled at = door(y, t);
    require_images("Couette::images", at.t);
    const double layer = 2 * std::sqrt(at.t);
    if (layer == 0) return at.y < 1 ? 0 : V;
    const auto pair = [&](double n) { return erfc((2 * n + 1 - at.y) / layer) - erfc((2 * n + 1 + at.y) / layer); };
    const auto rest = [&](double n) { return std::exp(-4 * n * n / (layer * layer)); };
    return V * sum(0, 1, pair, rest);
  }

  /// The straight line it tends to.
  double steady(double y) const { return V * door(y, 0).y; }

 private:
  Scaled door(double y, double t) const {
    require_finite("Couette", {{"V [m/s]", V}});
    return scaled("Couette", y, t, H, nu);
  }
};

}  // namespace touchstone::reference
