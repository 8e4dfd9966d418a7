#pragma once
#include "reference/start_up.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchstone::reference {

/// Start-up of plane Poiseuille flow: v_x(y, t) [m/s] between plates at y = 0 and y = H, of a fluid at rest that feels
/// the body force F along +x from t = 0. Morris, Fox & Zhu, J. Comput. Phys. 136 (1997), 214-226.
/// Sun et al. (36) prints the opposite sign, and its centreline values for 0.6, 0.8 and 1 s, 0.9723, 0.9962 and
/// 0.9995 mm/s, each lack a nine: 0.99723, 0.99962, 0.99995 mm/s.
/// Throws std::domain_error unless H and nu are positive, F is finite, y is in [0, H] and t is finite and not negative.
struct Poiseuille {
  double H;   // m     gap
  double F;   // m/s²  body force per unit mass
  double nu;  // m²/s  kinematic viscosity

  /// By the representation that is cheaper at this time; the two cost the same at nu t / H² = 0.007 (measured).
  double operator()(double y, double t) const { return nu / H * (t / H) < 0.007 ? images(y, t) : fourier(y, t); }

  /// The series (36) with its sign mended, for late times: refused for nu t / H² below 1e-7.
  /// Bound: in units of F H² / (8 nu) the odd terms from n on hold at most 32 / pi³ exp(-n² pi² nu t / H²) times
  /// 1 / n³ + 1 / (n + 2)³ + ... < 1 / n³ + 1 / (4 n²), together less than 1.3 exp(-n² pi² nu t / H²) / n².
  double fourier(double y, double t) const {
    const Scaled at = door(y, t);
    require_fourier("Poiseuille::fourier", at.t);
    const auto decay = [&](double k) { return std::exp(-k * k * at.t); };
    const auto wave = [&](double n) {
      const double k = n * std::numbers::pi;
      return std::sin(k * at.y) / (k * k * k) * decay(k);
    };
    const auto rest = [&](double n) { return 1.3 / (n * n) * decay(n * std::numbers::pi); };
    return F * H * H / nu * (at.y * (1 - at.y) / 2 - 4 * sum(1, 2, wave, rest));
  }

  /// Free fall F t, held back by the layers of both walls and their images, for early times: refused for nu t / H²
  /// above 10. After Carslaw & Jaeger, Conduction of Heat in Solids (1959), Laplace transform in powers of exp(-q H).
  /// Bound: the images alternate and shrink, so from k on they hold at most the k-th, and i²erfc z <= exp(-z²) / 4
  /// makes that at most 2 exp(-k² H² / (4 nu t)) of F t, which is 8 nu t / H² times F H² / (8 nu); the smaller scale
  /// counts.
  double images(double y, double t) const {
    const Scaled at = door(y, t);
    require_images("Poiseuille::images", at.t);
    const double layer = 2 * std::sqrt(at.t);
    if (layer == 0) return 0;
    const auto walls = [&](double k) {
      const double pair = i2erfc((k + at.y) / layer) + i2erfc((k + 1 - at.y) / layer);
      return std::fmod(k, 2) == 0 ? 4 * pair : -4 * pair;
    };
    const auto rest = [&](double k) { return 2 * std::max(1.0, 8 * at.t) * std::exp(-k * k / (layer * layer)); };
    return F * t * (1 - sum(0, 1, walls, rest));
  }

  /// The parabola it tends to.
  double steady(double y) const {
    const double place = door(y, 0).y;
    return F * H * H / (2 * nu) * place * (1 - place);
  }

 private:
  Scaled door(double y, double t) const {
    require_finite("Poiseuille", {{"F [m/s²]", F}});
    return scaled("Poiseuille", y, t, H, nu);
  }
};

}  // namespace touchstone::reference
