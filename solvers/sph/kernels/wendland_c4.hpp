#pragma once
#include "solvers/sph/kernels/kernel_laws.hpp"

namespace touchstone::sph {

/// Wendland's C4 kernel in the plane (Wendland, Adv. Comput. Math. 4 (1995), 389-396), smoother than C2 and narrower at
/// the same support of 2 h: for more neighbours. Particles do not pair (Dehnen & Aly, Mon. Not. R. Astron. Soc. 425
/// (2012), 1068-1082).
struct WendlandC4 {
  static constexpr double support = 2;
  static constexpr double sigma = 9 / (4 * std::numbers::pi);

  template <class Real>
  static constexpr Real w(const Real& q) {
    const Real s = positive_part(Real(1 - Number<Real>(0.5) * q)), s2 = s * s;
    return Number<Real>(sigma) * s2 * s2 * s2 * (1 + q * (3 + Number<Real>(35.0 / 12) * q));
  }
  template <class Real>
  static constexpr Real dw(const Real& q) {
    const Real s = positive_part(Real(1 - Number<Real>(0.5) * q)), s2 = s * s;
    return Number<Real>(-7.0 / 3 * sigma) * q * s2 * s2 * s * (2 + 5 * q);
  }
};
static_assert(obeys_kernel_laws<WendlandC4>());

}  // namespace touchstone::sph
