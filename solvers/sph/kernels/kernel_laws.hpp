#pragma once
/// What every smoothing kernel of the plane must obey, checked by compiling its header.
/// A kernel is a type with `support` (radius in units of h), `w(q)` [1/h²] and `dw(q)` = dw/dq, q = |r| / h,
/// both for a double and for Lanes.

#include "solvers/sph/pair_lanes.hpp"

#include <algorithm>
#include <numbers>

namespace touchstone::sph {

struct MeasuredKernel {
  long integral_per_million;  // over the plane
  double slope_error = 0;     // 1/h³  the largest difference between dw and the derivative of w
  double least_weight = 0;    // 1/h²
  double greatest_slope = 0;  // 1/h³
};
template <class Kernel>
consteval MeasuredKernel measured() {
  constexpr int slices = 3000;
  constexpr double dq = Kernel::support / slices, step = 1e-6;
  MeasuredKernel kernel{};
  double integral = 0;
  for (int k = 0; k < slices; ++k) {
    const double q = (k + 0.5) * dq, w = Kernel::w(q), dw = Kernel::dw(q);
    const double error = (Kernel::w(q + step) - Kernel::w(q - step)) / (2 * step) - dw;
    integral += 2 * std::numbers::pi * q * w * dq;
    kernel.slope_error = std::max(kernel.slope_error, error < 0 ? -error : error);
    kernel.least_weight = std::min(kernel.least_weight, w);
    kernel.greatest_slope = std::max(kernel.greatest_slope, dw);
  }
  kernel.integral_per_million = static_cast<long>(1e6 * integral + 0.5);
  return kernel;
}

/// Closes the header of a kernel: static_assert(obeys_kernel_laws<Kernel>()). Where it does not compile the message
/// names the law, and the compiler's note below it what was measured and what was expected.
template <class Kernel>
consteval bool obeys_kernel_laws() {
  constexpr MeasuredKernel kernel = measured<Kernel>();
  static_assert(kernel.integral_per_million == 1000000, "unit integral: 2 pi q w(q) over the support, per million");
  static_assert(kernel.slope_error < 1e-5, "slope: dw(q) is the derivative of w(q), but for 1e-5");
  static_assert(kernel.least_weight >= 0, "weight: w(q) is nowhere negative");
  static_assert(kernel.greatest_slope <= 0, "slope: dw(q) is nowhere positive");
  static_assert(Kernel::w(Kernel::support) == 0, "support: w is zero at its end");
  static_assert(Kernel::dw(Kernel::support) == 0, "support: dw is zero at its end");
  static_assert(Kernel::w(2 * Kernel::support) == 0, "support: w is zero beyond it");
  static_assert(Kernel::dw(2 * Kernel::support) == 0, "support: dw is zero beyond it");
  return true;
}

}  // namespace touchstone::sph
