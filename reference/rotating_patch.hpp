#pragma once
#include "reference/refuse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace touchstone::reference {

/// A square patch of an inviscid and incompressible fluid, centred at the origin, that begins to rotate as if rigid,
/// v = omega (y, -x), and that nothing holds together: A. Colagrossi, doctoral thesis, Rome 2005; D. Le Touze, A.
/// Colagrossi, G. Colicchio & M. Greco, Int. J. Numer. Meth. Fluids 73 (2013), 660-691. At the start the pressure obeys
/// laplace(p) = 2 rho omega² with p = 0 on all sides. Afterwards arms grow from the corners; mass, momentum, angular
/// momentum and kinetic energy stay. Throws std::domain_error unless L, omega and rho are positive and the place is in
/// the square.
struct RotatingPatch {
  double L;      // m      side
  double omega;  // 1/s    clockwise
  double rho;    // kg/m³

  double v_x(double y) const { return omega * y; }   // m/s  at the start
  double v_y(double x) const { return -omega * x; }  // m/s  at the start

  /// Pressure at the start [Pa]: rho omega² (x² - a²), and what is harmonic and lifts it to zero on the sides y = +-a:
  /// a series in cos(k x) cosh(k y) / cosh(k a) with k a = pi / 2, 3 pi / 2, ... and a = L / 2, summed until what is
  /// left is below 1e-12 rho omega² a².
  double p(double x, double y) const {
    check(x, y);
    const double a = L / 2;
    // The series is slow near the sides that it lifts: they are taken to be those farther away.
    const double across = std::max(std::abs(x), std::abs(y)) / a, along = std::min(std::abs(x), std::abs(y)) / a;
    double sum = across * across - 1, sign = 1;
    for (double ka = std::numbers::pi / 2;; ka += std::numbers::pi, sign = -sign) {
      const double height = (std::exp(ka * (along - 1)) + std::exp(-ka * (along + 1))) / (1 + std::exp(-2 * ka));
      if (height / (ka * ka) < 1e-12) break;
      sum += sign * 4 / (ka * ka * ka) * height * std::cos(ka * across);
    }
    return rho * omega * omega * a * a * sum;
  }

  double mass() const { return rho * L * L; }                                         // kg/m
  double kinetic_energy() const { return rho * omega * omega * L * L * L * L / 12; }  // J/m

 private:
  void check(double x, double y) const {
    require_positive("RotatingPatch", {{"L [m]", L}, {"omega [1/s]", omega}, {"rho [kg/m³]", rho}});
    for (const auto& [name, value] : {std::pair("x [m]", x), std::pair("y [m]", y)})
      if (!(std::abs(value) <= L / 2)) refuse("RotatingPatch", name, value, fmt::format("within +-{}", L / 2));
  }
};

}  // namespace touchstone::reference
