#pragma once
#include "solvers/sph/kernels/kernel_laws.hpp"

namespace touchstone::sph {

/// The quintic spline in the plane (Morris, Fox & Zhu 1997, table I). Support 3 h; with h equal to the particle spacing
/// its particles do not pair.
struct QuinticSpline {
  static constexpr double support = 3;
  static constexpr double sigma = 7 / (478 * std::numbers::pi);

  template <class Real>
  static constexpr Real w(const Real& q) {
    const Real a = positive_part(Real(3 - q)), b = positive_part(Real(2 - q)), c = positive_part(Real(1 - q));
    return NumberIn<Real>(sigma) * (fifth(a) - 6 * fifth(b) + 15 * fifth(c));
  }
  template <class Real>
  static constexpr Real dw(const Real& q) {
    const Real a = positive_part(Real(3 - q)), b = positive_part(Real(2 - q)), c = positive_part(Real(1 - q));
    return NumberIn<Real>(-5 * sigma) * (fourth(a) - 6 * fourth(b) + 15 * fourth(c));
  }

 private:
  template <class Real>
  static constexpr Real fourth(const Real& a) {
    return (a * a) * (a * a);
  }
  template <class Real>
  static constexpr Real fifth(const Real& a) {
    return fourth(a) * a;
  }
};
static_assert(obeys_kernel_laws<QuinticSpline>());

}  // namespace touchstone::sph
