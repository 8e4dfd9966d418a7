#pragma once
/// The stress that particles carry, as much of it as their fluid has: a pressure, or with viscosity a whole tensor.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/mpm/lanes.hpp"

#include <array>

namespace touchstone::mpm {

/// How the velocity changes along x and along y [1/s].
template <class Real>
struct Slopes {
  Pair<Real> x, y;

  Real divergence() const { return x.x() + y.y(); }
};

/// The stress of an inviscid fluid is its pressure.
template <class FluidLaw>
class Stress {
 public:
  explicit Stress(Eigen::Index particles) : pressure_(Scalars::Zero(particles)) {}

  /// Sums over the particles of a cell of pressure / density [m²/s²], as the nodes of the cell need them.
  template <class Real>
  struct Sums {
    Pair<Real> p_Xp = zero<Real>();
    Real Yp{};

    void add(const Stress& stress, int slot, const Real& per_density, const Real& X, const Real& Y) {
      const Real p = per_density * load<Real>(stress.pressure_, slot);
      p_Xp += Pair<Real>{p, X * p};
      Yp += Y * p;
    }
    Sums<double> total() const { return {mpm::total(p_Xp), mpm::total(Yp)}; }

    /// Internal forces on the corners of the cell (12), per mass of a particle; `per_cell` [1/m] is 1 / its size.
    template <class Shape>
    std::array<Vec2, 4> forces(const Vec2& per_cell) const {
      const auto along_x = Shape::slopes_along_X(p_Xp.x(), Yp), along_y = Shape::slopes_along_Y(p_Xp.x(), p_Xp.y());
      std::array<Vec2, 4> forces;
      for (int corner = 0; corner < 4; ++corner)
        forces[corner] = per_cell.cwiseProduct(Vec2(along_x[corner], along_y[corner]));
      return forces;
    }
  };

  /// (33).
  template <class Real>
  void update(int slot, const FluidLaw& fluid, const Real& density, const Slopes<Real>&) {
    store<Real>(fluid.pressure(density), pressure_, slot);
  }
  void copy(int from, int to) { pressure_[to] = pressure_[from]; }

 private:
  Scalars pressure_;  // Pa
};

/// The stress of a viscous fluid.
template <Viscous FluidLaw>
class Stress<FluidLaw> {
 public:
  explicit Stress(Eigen::Index particles)
      : xx_(Scalars::Zero(particles)), xy_(Scalars::Zero(particles)), yy_(Scalars::Zero(particles)) {}

  /// Sums over the particles of a cell of the rows of stress / density [m²/s²], as the nodes of the cell need them.
  template <class Real>
  struct Sums {
    Pair<Real> x = zero<Real>(), Yx = zero<Real>(), y = zero<Real>(), Xy = zero<Real>();

    void add(const Stress& stress, int slot, const Real& per_density, const Real& X, const Real& Y) {
      const Real xy = per_density * load<Real>(stress.xy_, slot);
      const Pair<Real> row_x{per_density * load<Real>(stress.xx_, slot), xy};
      const Pair<Real> row_y{xy, per_density * load<Real>(stress.yy_, slot)};
      x += row_x;
      Yx += Y * row_x;
      y += row_y;
      Xy += X * row_y;
    }
    Sums<double> total() const { return {mpm::total(x), mpm::total(Yx), mpm::total(y), mpm::total(Xy)}; }

    template <class Shape>
    std::array<Vec2, 4> forces(const Vec2& per_cell) const {
      const auto along_x = Shape::template slopes_along_X<Vec2>(-per_cell.x() * x, -per_cell.x() * Yx);
      const auto along_y = Shape::template slopes_along_Y<Vec2>(-per_cell.y() * y, -per_cell.y() * Xy);
      std::array<Vec2, 4> forces;
      for (int corner = 0; corner < 4; ++corner) forces[corner] = along_x[corner] + along_y[corner];
      return forces;
    }
  };

  /// (32) and (33): 2 mu eps - (2/3) mu tr(eps) I - P I.
  template <class Real>
  void update(int slot, const FluidLaw& fluid, const Real& density, const Slopes<Real>& of_v) {
    const double mu = fluid.viscosity;
    const Real isotropic = -2 * mu / 3 * of_v.divergence() - fluid.pressure(density);
    store<Real>(2 * mu * of_v.x.x() + isotropic, xx_, slot);
    store<Real>(mu * (of_v.x.y() + of_v.y.x()), xy_, slot);
    store<Real>(2 * mu * of_v.y.y() + isotropic, yy_, slot);
  }
  void copy(int from, int to) {
    for (Scalars* component : {&xx_, &xy_, &yy_}) (*component)[to] = (*component)[from];
  }

 private:
  Scalars xx_, xy_, yy_;  // Pa
};

}  // namespace touchstone::mpm
