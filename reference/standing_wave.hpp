#pragma once
#include "reference/refuse.hpp"

#include <cmath>
#include <numbers>

namespace touchstone::reference {

/// A standing gravity wave of small amplitude on water of depth h, between walls or crests a length L of wave apart:
/// the surface stands at y = h + a cos(k x) cos(omega t) exp(-2 nu k² t), with k = 2 pi / L. H. Lamb, Hydrodynamics
/// (1932), sections 228 and 348. Linear in k a; the decay is that of a potential flow over a floor that holds nothing
/// back, and to first order in nu k² / omega. Throws std::domain_error unless L, h and g are positive, nu is not
/// negative, a, x and y are finite, and t is finite and not negative.
struct StandingWave {
  double L;   // m      length of the wave
  double a;   // m      amplitude at the start
  double h;   // m      depth at rest
  double g;   // m/s²
  double nu;  // m²/s   kinematic viscosity

  /// Height of the surface above that at rest [m].
  double surface(double x, double t) const {
    check(x, 0, t);
    return a * fade(t) * std::cos(k() * x) * std::cos(omega() * t);
  }
  double v_x(double x, double y, double t) const {
    check(x, y, t);
    return speed(t) * std::cosh(k() * y) / std::sinh(k() * h) * std::sin(k() * x);
  }
  double v_y(double x, double y, double t) const {
    check(x, y, t);
    return -speed(t) * std::sinh(k() * y) / std::sinh(k() * h) * std::cos(k() * x);
  }

  double k() const { return 2 * std::numbers::pi / L; }                     // 1/m
  double omega() const { return std::sqrt(g * k() * std::tanh(k() * h)); }  // 1/s
  double decay_rate() const { return 2 * nu * k() * k(); }  // 1/s  of the amplitude; energy falls twice as fast

 private:
  double fade(double t) const { return std::exp(-decay_rate() * t); }
  /// Of the surface at a crest, upwards where it falls [m/s].
  double speed(double t) const { return a * omega() * fade(t) * std::sin(omega() * t); }
  void check(double x, double y, double t) const {
    require_positive("StandingWave", {{"L [m]", L}, {"h [m]", h}, {"g [m/s²]", g}});
    if (!(std::isfinite(nu) && nu >= 0)) refuse("StandingWave", "nu [m²/s]", nu, "a finite number, not negative");
    require_finite("StandingWave", {{"a [m]", a}, {"x [m]", x}, {"y [m]", y}});
    require_time("StandingWave", t);
  }
};

}  // namespace touchstone::reference
