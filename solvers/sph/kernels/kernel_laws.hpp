#pragma once
/// What every smoothing kernel of the plane must obey, checked by compiling its header.
/// A kernel is a type with `support` (radius in units of h), `w(q)` [1/h²] and `dw(q)` = dw/dq, q = |r| / h,
/// both for a double and for Lanes.

#include "solvers/sph/lanes.hpp"

#include <numbers>

namespace touchstone::sph {

/// Unit integral, slope equal to the derivative, no negative weight, nothing beyond the support.
template <class Kernel>
consteval bool obeys_kernel_laws() {
  constexpr int slices = 3000;
  constexpr double dq = Kernel::support / slices;
  double integral = 0;
  for (int k = 0; k < slices; ++k) {
    const double q = (k + 0.5) * dq, step = 1e-6;
    integral += 2 * std::numbers::pi * q * Kernel::w(q) * dq;
    const double slope = (Kernel::w(q + step) - Kernel::w(q - step)) / (2 * step);
    const double gap = slope - Kernel::dw(q);
    if (gap > 1e-5 || gap < -1e-5 || Kernel::w(q) < 0 || Kernel::dw(q) > 0) return false;
  }
  const double excess = integral - 1;
  return excess < 1e-6 && excess > -1e-6 && Kernel::w(Kernel::support) == 0 && Kernel::dw(Kernel::support) == 0 &&
         Kernel::w(2 * Kernel::support) == 0 && Kernel::dw(2 * Kernel::support) == 0;
}

}  // namespace touchstone::sph
