#pragma once
/// What cases of a stretching drop share (vnv/flows/elliptic_drop.cpp).

#include "reference/elliptic_drop.hpp"
#include "vnv/flows/flow.hpp"
#include "vnv/judge/norms.hpp"
#include "vnv/measures/profile.hpp"
#include "vnv/methods/free_surface_methods.hpp"

namespace touchstone::vnv::drop {

inline constexpr double R = 1, end = 0.8;  // m, s  the drop is twice as long, and four times as long as wide

inline const Quantity axes_error{"Linf of both half-axes until the length has doubled", "%", Kind::norm},
    pressure_error{"error of the central pressure, relative to its initial value", "%", Kind::deviation};

/// Of both half-axes over time, relative to those at the start, in per cent.
inline double largest_error(const reference::EllipticDrop& drop, const std::vector<double>& times,
                            const std::vector<std::vector<double>>& axes) {
  double largest = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const auto exact = drop.at(times[k]);
    largest = norms::larger_magnitude(largest, axes[k][0] / axes[0][0] * drop.R / exact.a - 1);
    largest = norms::larger_magnitude(largest, axes[k][1] / axes[0][1] * drop.R / exact.b - 1);
  }
  return 100 * std::abs(largest);
}
/// Of those that are monitored.
inline Measurement error_of_axes(const reference::EllipticDrop& drop) {
  return of_finished_run(axes_error,
                [=](const Run& run) { return largest_error(drop, run.history.time, run.history.values); });
}

/// Mean over the particles within a fifth of the drop's half-axes from its centre.
inline Measurement error_of_pressure(const reference::EllipticDrop& drop) {
  return of_each_sample(pressure_error, [=](const Samples& s) {
    const auto exact = drop.at(s.time);
    const double error = mean_where(
        s, [&](const Samples&, Eigen::Index p) { return s.pressure[p] - exact.p(s.x(0, p), s.x(1, p)); },
        [&](const Vec2& x) { return !(Vec2(x.x() / exact.a, x.y() / exact.b).norm() > 0.2); });
    return 100 * error / drop.at(0).p_centre;
  });
}

/// The methods that run it.
inline std::vector<Method> methods_on(const Scene<Tait>& scene) {
  constexpr double output_interval = 0.1;  // s  of which every step divides the times
  return {mpm_as_printed(scene, output_interval, 0.4),
          mpm_affine(scene, output_interval, 0.4),
          mpm_apic(scene, output_interval),
          mpm_xpic(scene, output_interval),
          sph_as_printed(scene, output_interval, 0.2),
          sph_corrected(scene, output_interval, {.alpha = 0.005})};
}

}  // namespace touchstone::vnv::drop
