#pragma once
#include "solvers/sph/kernels/kernel_laws.hpp"

namespace touchstone::sph {

/// Wendland's C2 kernel in the plane (Wendland, Adv. Comput. Math. 4 (1995), 389-396). Support 2 h. Its Fourier
/// transform is nowhere negative: particles do not pair, however many neighbours they have (Dehnen & Aly, Mon. Not. R.
/// Astron. Soc. 425 (2012), 1068-1082).
struct WendlandC2 {
  static constexpr double support = 2;
  static constexpr double sigma = 7 / (4 * std::numbers::pi);

  template <class Real>
  static constexpr Real w(const Real& q) {
    const Real s = positive_part(Real(1 - NumberIn<Real>(0.5) * q)), s2 = s * s;
    return NumberIn<Real>(sigma) * s2 * s2 * (1 + 2 * q);
  }
  template <class Real>
  static constexpr Real dw(const Real& q) {
    const Real s = positive_part(Real(1 - NumberIn<Real>(0.5) * q));
    return NumberIn<Real>(-5 * sigma) * q * s * s * s;
  }
  template <class Real>
  static constexpr Real dw_per_q(const Real& q) {
    const Real s = positive_part(Real(1 - NumberIn<Real>(0.5) * q));
    return NumberIn<Real>(-5 * sigma) * s * (s * s);
  }
};
static_assert(obeys_kernel_laws<WendlandC2>());

}  // namespace touchstone::sph
