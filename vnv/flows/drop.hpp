#pragma once
/// A round drop that a strain stretches along x [Monaghan 1994], in nothing.

#include "reference/elliptic_drop.hpp"
#include "vnv/judge/norms.hpp"
#include "vnv/measures/half_axes.hpp"
#include "vnv/methods/free_surface_methods.hpp"

namespace touchstone::vnv::drop {

inline constexpr double R = 1, s0 = 1, rho0 = 1000, c = 60;  // m, 1/s, kg/m³, m/s
inline constexpr double end = 0.8;              // s  the drop is twice as long, and four times as long as wide
inline constexpr double output_interval = 0.1;  // s  of which every step divides the times
inline const reference::EllipticDrop exact{.R = R, .s0 = s0, .rho = rho0};

inline Vec2 velocity(const Vec2& x, double t) {
  const double s = exact.at(t).s;
  return {s * x.x(), -s * x.y()};
}
inline double pressure(const Vec2& x, double t) { return std::max(0.0, exact.at(t).p(x.x(), x.y())); }

/// Those places of a lattice that are in the drop at the start.
inline Vectors within(const Vectors& lattice) {
  std::vector<Eigen::Index> inside;
  for (Eigen::Index p = 0; p < lattice.cols(); ++p)
    if (lattice.col(p).norm() < R) inside.push_back(p);
  return lattice(Eigen::all, inside);
}

inline Scene<Tait> scene() {
  return {.domain = {.box = {.low = {-2.6, -2.6}, .high = {2.6, 2.6}}},
          .fluid = {.density = rho0, .bulk_modulus = rho0 * c * c / 7},
          .filled = {.low = {-R, -R}, .high = {R, R}},
          .start = {.velocity = [](const Vec2& x) { return velocity(x, 0); },
                    .pressure = [](const Vec2& x) { return pressure(x, 0); },
                    .places = within}};
}

/// Both half-axes over time.
inline Watch monitored_axes() {
  return {.every = 0.02,
          .see =
              [](const Samples& s) {
                const auto axes = half_axes(s);
                return std::vector{axes[0], axes[1]};
              },
          .quantities = {{"longer half-axis", "m"}, {"shorter half-axis", "m"}}};
}

inline const Quantity axes_error{"Linf of both half-axes until the length has doubled", "%", Kind::norm};

/// The half-axes, relative to those of the particles at the start, against the exact ones, at all times until the end.
inline std::vector<Value> error_of_axes(const Level& level, const Run& run) {
  double largest = 0;
  for (std::size_t k = 0; k < run.history.time.size(); ++k) {
    const auto state = exact.at(run.history.time[k]);
    largest = norms::larger_magnitude(largest, run.history.seen[k][0] / run.history.seen[0][0] * R / state.a - 1);
    largest = norms::larger_magnitude(largest, run.history.seen[k][1] / run.history.seen[0][1] * R / state.b - 1);
  }
  if (!run.summary.finished) return {};
  return {{level.name, level.spacing, end, axes_error, 100 * std::abs(largest)}};
}

/// The methods that run it, for a scene.
inline std::vector<Method> methods_on(const Scene<Tait>& seen) {
  return {mpm_as_printed(seen, output_interval, 0.4),
          mpm_affine(seen, output_interval, 0.4),
          mpm_apic(seen, output_interval),
          mpm_xpic(seen, output_interval),
          sph_as_printed(seen, output_interval, 0.2),
          sph_corrected(seen, output_interval, {.alpha = 0.005})};
}

}  // namespace touchstone::vnv::drop
