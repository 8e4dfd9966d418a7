#pragma once
#include "reference/refuse.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <memory>

namespace touchstone::reference {

/// A round drop of radius R that a strain stretches along x: v = (s x, -s y) with s = s0 at t = 0, in an inviscid and
/// incompressible fluid without gravity or surface tension; J. J. Monaghan, J. Comput. Phys. 110 (1994), 399-406. It
/// stays an ellipse with half-axes a and b = R² / a. On the surface the pressure is zero, which with
/// p = -(rho / 2) ((s' + s²) x² + (s² - s') y²) + p_centre gives a' = s a and s' = -s² (a² - b²) / (a² + b²).
/// Throws std::domain_error unless R, rho and s0 are positive and t is finite, not negative and at most 1000 / s0, when
/// the drop is two million times as long as it is wide.
struct EllipticDrop {
  double R;    // m      radius at the start
  double s0;   // 1/s    rate of strain at the start
  double rho;  // kg/m³

  /// The drop at a time.
  struct State {
    double a, b;      // m    half-axes along x and y
    double s;         // 1/s  rate of strain
    double p_centre;  // Pa

    /// Pressure [Pa]; negative outside the drop, where there is none.
    double p(double x, double y) const { return p_centre * (1 - (x / a) * (x / a) - (y / b) * (y / b)); }
  };

  /// Integrated from the start by Runge, Kutta, Prince and Dormand to a relative 1e-13 [GSL, Ordinary Differential
  /// Equations].
  State at(double t) const {
    require_positive("EllipticDrop", {{"R [m]", R}, {"s0 [1/s]", s0}, {"rho [kg/m³]", rho}});
    require_time("EllipticDrop", t);
    constexpr double latest = 1000;  // s0 t
    if (s0 * t > latest) refuse("EllipticDrop", "t [s]", t, fmt::format("at most {}", latest / s0));
    double state[] = {1, 1};  // a / R and s / s0, over s0 t
    integrate(s0 * t, state);
    const double a = R * state[0], b = R * R / a, s = s0 * state[1];
    return {.a = a, .b = b, .s = s, .p_centre = rho * s * s * a * a * b * b / (a * a + b * b)};
  }

 private:
  static void integrate(double until, double* state) {
    const auto rates = [](double, const double y[], double dydt[], void*) -> int {
      const double a2 = y[0] * y[0], b2 = 1 / a2;
      dydt[0] = y[1] * y[0];
      dydt[1] = -y[1] * y[1] * (a2 - b2) / (a2 + b2);
      return GSL_SUCCESS;
    };
    gsl_odeiv2_system system{rates, nullptr, 2, nullptr};
    const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3, 0, 1e-13), gsl_odeiv2_driver_free);
    double time = 0;
    if (until > 0 && gsl_odeiv2_driver_apply(driver.get(), &time, until, state) != GSL_SUCCESS)
      refuse("EllipticDrop", "s0 t", until, "a time that can be reached");
  }
};

}  // namespace touchstone::reference
