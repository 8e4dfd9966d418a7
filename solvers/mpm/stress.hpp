#pragma once
/// The stress that particles carry, as much of it as their fluid has: a pressure, or with viscosity a whole tensor. It
/// is kept per density [m²/s²], as the nodes want it.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/mpm/cell_lanes.hpp"

namespace touchstone::mpm {

/// How the velocity changes along x and along y [1/s].
template <class Real>
struct Slopes {
  Real xx, yx;  // of v_x and v_y along x
  Real xy, yy;  // of v_x and v_y along y

  Real divergence() const { return xx + yy; }
};

/// Pressure [Pa] by Tait's law (33) from the expansion e = rho0 / rho - 1, with (1 + d)^7 - 1 multiplied out for
/// d = rho / rho0 - 1: the difference from the density at rest is small, and all its digits count.
template <class Real>
Real pressure_of(const Tait& fluid, const Real& expansion) {
  static_assert(Tait::gamma == 7);
  const Real d = -expansion / (1 + expansion), d2 = d * d;
  const Real sum = (7 + 21 * d) + d2 * ((35 + 35 * d) + d2 * ((21 + 7 * d) + d2));
  return fill<Real>(fluid.bulk_modulus) * d * sum;
}

/// The stress of an inviscid fluid is its pressure.
template <class FluidLaw, class Number>
class Stress {
 public:
  explicit Stress(int slots) : pressure_(slots) {}

  /// The component on `axis` that acts along `along` [m²/s²].
  template <class Real>
  Real of(int /*axis*/, int /*along*/, int slot) const {
    return -load<Real>(&pressure_[slot]);
  }

  /// Keeps rates of strain until `update` needs them; or none, for a pressure.
  template <class Real, class Store>
  static void keep_rates(int, const Slopes<Real>&, const Store&) {}
  template <class Real>
  static Slopes<Real> kept_rates(int) {
    return {Real{}, Real{}, Real{}, Real{}};
  }

  /// (33), of the particles from `slot` on that `Store` writes.
  template <class Real, class Store>
  void update(int slot, const FluidLaw& fluid, const Real& expansion, const Slopes<Real>&, const Store& write) {
    const Real specific_volume = fill<Real>(1 / fluid.density) * (1 + expansion);  // m³/kg
    write(specific_volume * pressure_of<Real>(fluid, expansion), &pressure_[slot]);
  }

  template <class F>
  void for_fields(const F& f) {
    f(pressure_);
  }

 private:
  Field<Number> pressure_;
};

/// The stress of a viscous fluid.
template <Viscous FluidLaw, class Number>
class Stress<FluidLaw, Number> {
 public:
  explicit Stress(int slots) : xx_(slots), xy_(slots), yy_(slots) {}

  template <class Real>
  Real of(int axis, int along, int slot) const {
    return load<Real>(&(axis != along ? xy_ : axis == 0 ? xx_ : yy_)[slot]);
  }

  /// In place of the stress.
  template <class Real, class Store>
  void keep_rates(int slot, const Slopes<Real>& of_v, const Store& write) {
    write(of_v.xx, &xx_[slot]);
    write(of_v.xy + of_v.yx, &xy_[slot]);
    write(of_v.yy, &yy_[slot]);
  }
  template <class Real>
  Slopes<Real> kept_rates(int slot) const {
    return {.xx = load<Real>(&xx_[slot]), .yx = Real{}, .xy = load<Real>(&xy_[slot]), .yy = load<Real>(&yy_[slot])};
  }

  /// (32) and (33), per density: 2 mu eps - (2/3) mu tr(eps) I - P I.
  template <class Real, class Store>
  void update(int slot, const FluidLaw& fluid, const Real& expansion, const Slopes<Real>& of_v, const Store& write) {
    const Real specific_volume = fill<Real>(1 / fluid.density) * (1 + expansion);
    const Real nu = fill<Real>(fluid.viscosity) * specific_volume;  // m²/s
    const Real isotropic =
        fill<Real>(-2.0 / 3) * nu * of_v.divergence() - specific_volume * pressure_of<Real>(fluid, expansion);
    write(2 * nu * of_v.xx + isotropic, &xx_[slot]);
    write(nu * (of_v.xy + of_v.yx), &xy_[slot]);
    write(2 * nu * of_v.yy + isotropic, &yy_[slot]);
  }

  template <class F>
  void for_fields(const F& f) {
    f(xx_);
    f(xy_);
    f(yy_);
  }

 private:
  Field<Number> xx_, xy_, yy_;
};

}  // namespace touchstone::mpm
