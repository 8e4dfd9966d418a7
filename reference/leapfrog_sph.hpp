#pragma once
#include "reference/refuse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchstone::reference {

/// Sound in weakly compressible SPH without dissipation, at rest on a square lattice that repeats along both axes,
/// whose velocities and densities are stepped in turn (leapfrog, kick-drift-kick).
///
/// Linearised, a wave exp(i k x) obeys drho/dt = -i rho0 G.v and dv/dt = -i c² / rho0 G rho, with
/// G(k) = sum V W'(r) / r x sin(k x) over the neighbours: symmetric sums see no other derivative. It oscillates with
/// omega = c |G|, and central steps of it neither grow nor fade up to omega dt = 2 (Violeau & Leroy, J. Comput. Phys.
/// 256 (2014), 388-415, whose integrals are sums here).
///
/// Throws std::domain_error unless h is positive and a side has two particles or more.
struct LeapfrogSph {
  double (*slope)(double q);  // -  of a kernel in the plane: h³ dW/dr at q = r / h
  double support;             // -  where it ends, in q
  double h;                   // -  smoothing length over the spacing
  int across;                 // particles along a side

  /// The longest step that is stable, as an acoustic Courant number c dt over the spacing.
  double largest_stable_courant() const {
    require_positive("LeapfrogSph", {{"h [spacings]", h}, {"support [-]", support}});
    if (across < 2) refuse("LeapfrogSph", "across", across, "2 particles or more");
    double largest = 0;
    for (int i = 0; i <= across / 2; ++i)
      for (int j = 0; j <= i; ++j)  // the others mirror these
        largest = std::max(largest, gradient(2 * std::numbers::pi * i / across, 2 * std::numbers::pi * j / across));
    return 2 / largest;
  }

  /// |G| of a wave with these numbers along the axes, times the spacing.
  double gradient(double k_x, double k_y) const {
    const int reach = static_cast<int>(std::ceil(support * h));
    double x = 0, y = 0;
    for (int i = -reach; i <= reach; ++i)
      for (int j = -reach; j <= reach; ++j) {
        const double r = std::hypot(i, j);
        if (r == 0 || r >= support * h) continue;
        const double weight = slope(r / h) / (h * h * h * r) * std::sin(k_x * i + k_y * j);
        x += weight * i;
        y += weight * j;
      }
    return std::hypot(x, y);
  }
};

/// The slope of the quintic spline, support 3 (Morris, Fox & Zhu 1997, table I).
inline double slope_of_quintic_spline(double q) {
  const auto fourth = [](double a) { return a > 0 ? std::pow(a, 4) : 0; };
  return -35 / (478 * std::numbers::pi) * (fourth(3 - q) - 6 * fourth(2 - q) + 15 * fourth(1 - q));
}

/// That of Wendland's C2 function, support 2 (Wendland 1995).
inline double slope_of_wendland_c2(double q) {
  return q < 2 ? -35 / (4 * std::numbers::pi) * q * std::pow(1 - q / 2, 3) : 0;
}

/// With the quintic spline and h one spacing.
inline LeapfrogSph quintic_leapfrog(int across) { return {slope_of_quintic_spline, 3, 1, across}; }

}  // namespace touchstone::reference
