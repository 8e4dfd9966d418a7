#pragma once
#include "solvers/sph/kernels/kernel_laws.hpp"

namespace touchstone::sph {

/// The cubic spline in the plane (Monaghan & Lattanzio 1985); Sun et al. (22). Support 2 h.
/// Written as a difference of truncated cubes, so that a loop over pairs has no branch.
struct CubicSpline {
  static constexpr double support = 2;
  static constexpr double sigma = 10 / (7 * std::numbers::pi);

  template <class Real>
  static constexpr Real w(const Real& q) {
    const Real a = positive_part(Real(2 - q)), b = positive_part(Real(1 - q));
    return NumberIn<Real>(sigma) * (NumberIn<Real>(0.25) * a * a * a - b * b * b);
  }
  template <class Real>
  static constexpr Real dw(const Real& q) {
    const Real a = positive_part(Real(2 - q)), b = positive_part(Real(1 - q));
    return NumberIn<Real>(-0.75 * sigma) * a * a + NumberIn<Real>(3 * sigma) * b * b;
  }
};
static_assert(obeys_kernel_laws<CubicSpline>());

}  // namespace touchstone::sph
