#pragma once
#include "reference/refuse.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace touchstone::reference {

/// A flow that was chosen, and the body force that makes it a solution (method of manufactured solutions: P. J. Roache,
/// J. Fluids Eng. 124 (2002), 4-10; K. Salari & P. Knupp, SAND2000-1444). It repeats along x and y with the period L.
/// Every term of the equations of motion takes part: the flow is unsteady, crosses the grid, is compressed and
/// stretched, and its pressure follows Tait's law, P = K ((rho / rho0)^7 - 1).
///
/// Particles have no sources of mass, so continuity has to hold by itself: the density rests,
/// rho = rho0 (1 + ripple cos kx cos ky), and the momentum rho v = rho0 a(t) M has no divergence, with
/// M = U (0.3 - cos kx sin ky, 0.2 + sin kx cos ky), a = 1 + sin(omega t) / 2 and k = 2 pi / L.
///
/// Throws std::domain_error unless L, rho0, K and mu are positive, 0 <= ripple < 1, and all else is finite.
struct Manufactured {
  double L;       // m      period
  double U;       // m/s
  double omega;   // 1/s
  double rho0;    // kg/m³  at no pressure
  double ripple;  // -
  double K;       // Pa     of Tait's law
  double mu;      // Pa s

  double density(double x, double y) const { return rho0 * at(x, y).R; }
  double pressure(double x, double y) const { return K * (std::pow(at(x, y).R, 7) - 1); }
  std::array<double, 2> velocity(double x, double y, double t) const {
    const Terms p = at(x, y);
    return {a(t) * p.g[0].v, a(t) * p.g[1].v};
  }

  /// The force [m/s²] that sustains it: Dv/Dt + grad P / rho - (mu / rho) (laplacian v + grad div v / 3).
  std::array<double, 2> force(double x, double y, double t) const {
    const Terms p = at(x, y);
    const double now = a(t), rate = omega / 2 * std::cos(omega * t);
    const double push = 7 * K / rho0 * (p.R * p.R) * (p.R * p.R) * p.R;
    const std::array<double, 2> R_along{p.R_x, p.R_y},
        compressed{p.g[0].xx + p.g[1].xy, p.g[0].xy + p.g[1].yy};  // the slopes of div g
    std::array<double, 2> b;
    for (int i = 0; i < 2; ++i) {
      const Field& g = p.g[i];
      const double carried = p.g[0].v * g.x + p.g[1].v * g.y;
      b[i] = rate * g.v + now * now * carried + push * R_along[i] -
             mu / (rho0 * p.R) * now * (g.xx + g.yy + compressed[i] / 3);
    }
    return b;
  }

 private:
  struct Field {
    double v, x, y, xx, xy, yy;  // value and derivatives
  };
  struct Terms {
    double R, R_x, R_y;      // density over rho0
    std::array<Field, 2> g;  // M / R
  };

  double a(double t) const {
    require_finite("Manufactured", {{"t [s]", t}, {"omega [1/s]", omega}});
    return 1 + std::sin(omega * t) / 2;
  }

  /// M / R, by (M / R)' = (M' - (M / R) R') / R.
  static Field quotient(const Field& m, const Field& r) {
    const double per = 1 / r.v;
    Field g{};
    g.v = m.v * per;
    g.x = (m.x - g.v * r.x) * per;
    g.y = (m.y - g.v * r.y) * per;
    g.xx = (m.xx - 2 * g.x * r.x - g.v * r.xx) * per;
    g.xy = (m.xy - g.x * r.y - g.y * r.x - g.v * r.xy) * per;
    g.yy = (m.yy - 2 * g.y * r.y - g.v * r.yy) * per;
    return g;
  }

  Terms at(double x, double y) const {
    require_positive("Manufactured", {{"L [m]", L}, {"rho0 [kg/m³]", rho0}, {"K [Pa]", K}, {"mu [Pa s]", mu}});
    if (!(ripple >= 0 && ripple < 1)) refuse("Manufactured", "ripple", ripple, "a number from 0 to below 1");
    require_finite("Manufactured", {{"U [m/s]", U}, {"x [m]", x}, {"y [m]", y}});
    const double k = 2 * std::numbers::pi / L;
    const double sx = std::sin(k * x), cx = std::cos(k * x), sy = std::sin(k * y), cy = std::cos(k * y);
    // c c, c s, s c and s s with their derivatives, of c = cos and s = sin of kx and ky
    const auto product = [&](double value, double turned_x, double turned_y, double turned_both, double scale) {
      return Field{scale * value,          scale * k * turned_x,        scale * k * turned_y,
                   -scale * k * k * value, scale * k * k * turned_both, -scale * k * k * value};
    };
    Field r = product(cx * cy, -sx * cy, -cx * sy, sx * sy, ripple);
    r.v += 1;
    Field m_x = product(cx * sy, -sx * sy, cx * cy, -sx * cy, -U),
          m_y = product(sx * cy, cx * cy, -sx * sy, -cx * sy, U);
    m_x.v += 0.3 * U;
    m_y.v += 0.2 * U;
    return {r.v, r.x, r.y, {quotient(m_x, r), quotient(m_y, r)}};
  }
};

}  // namespace touchstone::reference
