#pragma once
#include "solvers/sph/kernels/kernel_laws.hpp"

namespace touchstone::sph {

/// Wendland's C6 kernel in the plane (Dehnen & Aly, Mon. Not. R. Astron. Soc. 425 (2012), table 1). Support 2 h.
struct WendlandC6 {
  static constexpr double support = 2;
  static constexpr double sigma = 78 / (28 * std::numbers::pi);

  template <class Real>
  static constexpr Real w(const Real& q) {
    const Real s = NumberIn<Real>(0.5) * q, rest = positive_part(Real(1 - s)), rest2 = rest * rest,
               rest4 = rest2 * rest2;
    return NumberIn<Real>(sigma) * rest4 * rest4 * (1 + s * (8 + s * (25 + 32 * s)));
  }
  template <class Real>
  static constexpr Real dw(const Real& q) {
    const Real s = NumberIn<Real>(0.5) * q, rest = positive_part(Real(1 - s)), rest2 = rest * rest,
               rest4 = rest2 * rest2;
    return NumberIn<Real>(-11 * sigma) * s * rest4 * rest2 * rest * (1 + s * (7 + 16 * s));
  }
};
static_assert(obeys_kernel_laws<WendlandC6>());

}  // namespace touchstone::sph
