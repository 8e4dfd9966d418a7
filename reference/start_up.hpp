#pragma once
/// What the two start-up flows between plates share: their scales, and the sums that stop at a bound.

#include "reference/refuse.hpp"

#include <gsl/gsl_sf_erf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

namespace touchstone::reference {

/// A place and a time in units of the gap H and of its viscous time H² / nu.
struct Scaled {
  double y;  // y / H, in [0, 1]
  double t;  // nu t / H²
};

/// Throws std::domain_error unless H, nu are positive, y [m] is in [0, H] but for rounding, and t [s] is not negative.
inline Scaled scaled(std::string_view where, double y, double t, double H, double nu) {
  constexpr double rounding = 1e-12;
  require_positive(where, {{"H [m]", H}, {"nu [m²/s]", nu}});
  require_time(where, t);
  if (!(y >= -rounding * H && y <= (1 + rounding) * H)) refuse(where, "y [m]", y, fmt::format("a place in [0, {}]", H));
  return {std::clamp(y / H, 0.0, 1.0), nu / H * (t / H)};
}

/// The Fourier sums hold from this nu t / H² on; earlier they would add thousands of terms.
inline constexpr double earliest_fourier = 1e-7;

/// The images hold up to this nu t / H²; later they cancel one another and their rounding shows (1e-13 here).
inline constexpr double latest_images = 10;

inline void require_fourier(std::string_view where, double t) {
  if (t < earliest_fourier)
    refuse(where, "nu t / H²", t, fmt::format("at least {}; earlier, images", earliest_fourier));
}

inline void require_images(std::string_view where, double t) {
  if (t > latest_images) refuse(where, "nu t / H²", t, fmt::format("at most {}; later, fourier", latest_images));
}

/// What a sum may leave out, as a fraction of the velocity scale of its flow.
inline constexpr double negligible = std::numeric_limits<double>::epsilon() / 2;

/// term(first) + term(first + stride) + ..., up to the n from which on all that is left, at most rest(n), is
/// negligible.
template <class Term, class Bound>
double sum(double first, double stride, Term term, Bound rest) {
  double total = 0;
  for (double n = first; rest(n) > negligible; n += stride) total += term(n);
  return total;
}

/// erfc z for z >= 0; zero from where exp(-z²) leaves the range of a double, since GSL returns NaN for very large z.
inline double erfc(double z) { return z < 27 ? gsl_sf_erfc(z) : 0; }

/// The second repeated integral of erfc for z >= 0: Carslaw & Jaeger, Conduction of Heat in Solids (1959), appendix II.
/// For large z its two parts cancel and relative accuracy is lost as z⁴; the error itself stays a rounding error of
/// i²erfc(0) = 1/4, which is all that a sum of images needs.
inline double i2erfc(double z) {
  return z < 27 ? ((1 + 2 * z * z) * erfc(z) - 2 * std::numbers::inv_sqrtpi * z * std::exp(-z * z)) / 4 : 0;
}

}  // namespace touchstone::reference
