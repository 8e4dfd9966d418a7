#pragma once
/// A round drop that a strain stretches along x [Monaghan 1994], in nothing.

#include "reference/elliptic_drop.hpp"
#include "vnv/flows/flow.hpp"
#include "vnv/judge/norms.hpp"
#include "vnv/measures/field_errors.hpp"
#include "vnv/measures/half_axes.hpp"
#include "vnv/measures/profile.hpp"
#include "vnv/methods/free_surface_methods.hpp"

namespace touchstone::vnv::drop {

inline constexpr double R = 1, s0 = 1, rho0 = 1000, c = 60;  // m, 1/s, kg/m³, m/s
inline constexpr double end = 0.8;              // s  the drop is twice as long, and four times as long as wide
inline constexpr double output_interval = 0.1;  // s  of which every step divides the times
inline const reference::EllipticDrop exact{.R = R, .s0 = s0, .rho = rho0};

/// The velocity, with the drop of each time found once for all particles.
inline VelocityTruth velocity_of(const reference::EllipticDrop& flow) {
  return [flow, known = -1.0, s = 0.0](const Vec2& x, double t) mutable -> Vec2 {
    if (t != known) s = flow.at(known = t).s;
    return {s * x.x(), -s * x.y()};
  };
}
inline Vec2 velocity(const Vec2& x, double t) { return velocity_of(exact)(x, t); }
inline double pressure(const Vec2& x, double t) { return std::max(0.0, exact.at(t).p(x.x(), x.y())); }

/// Those places of a lattice that are in a drop of this radius [m].
inline Vectors within(const Vectors& lattice, double radius = R) {
  std::vector<Eigen::Index> inside;
  for (Eigen::Index p = 0; p < lattice.cols(); ++p)
    if (lattice.col(p).norm() < radius) inside.push_back(p);
  return lattice(Eigen::all, inside);
}

inline Scene<Tait> scene_with(const reference::EllipticDrop& flow, double sound_speed) {
  const double far = 2.6 * flow.R;
  const auto start = flow.at(0);
  return {.domain = {.box = {.low = {-far, -far}, .high = {far, far}}},
          .fluid = {.density = flow.rho, .bulk_modulus = flow.rho * sound_speed * sound_speed / Tait::gamma},
          .filled = {.low = {-flow.R, -flow.R}, .high = {flow.R, flow.R}},
          .start = {.velocity = [start](const Vec2& x) -> Vec2 {
                      return {start.s * x.x(), -start.s * x.y()};
                    },
                    .pressure = [start](const Vec2& x) { return std::max(0.0, start.p(x.x(), x.y())); },
                    .places = [radius = flow.R](const Vectors& lattice) { return within(lattice, radius); }}};
}
inline Scene<Tait> scene() { return scene_with(exact, c); }

/// Both half-axes over time.
inline Monitor monitored_axes() {
  return {.interval = 0.02,
          .evaluate =
              [](const Samples& s) {
                const auto axes = half_axes(s);
                return std::vector{axes.longer, axes.shorter};
              },
          .quantities = {{"longer half-axis", "m"}, {"shorter half-axis", "m"}}};
}

inline const Quantity axes_error{"Linf of both half-axes until the length has doubled", "%", Kind::norm};

/// The half-axes, relative to those of the particles at the start, against the exact ones, at all times until the end.
inline Measurement error_of_axes_in(const reference::EllipticDrop& flow) {
  return [flow](const Level& level, const Run& run) -> std::vector<Value> {
    if (!run.summary.finished) return {};
    double largest = 0;
    for (std::size_t k = 0; k < run.history.time.size(); ++k) {
      const auto state = flow.at(run.history.time[k]);
      largest =
          norms::larger_magnitude(largest, run.history.values[k][0] / run.history.values[0][0] * flow.R / state.a - 1);
      largest =
          norms::larger_magnitude(largest, run.history.values[k][1] / run.history.values[0][1] * flow.R / state.b - 1);
    }
    return {{level.name, level.spacing, run.summary.end_time, axes_error, 100 * std::abs(largest)}};
  };
}
inline const Measurement error_of_axes = error_of_axes_in(exact);

inline const Quantity pressure_error{"error of the central pressure, relative to its initial value", "%",
                                     Kind::deviation};

/// Mean over the particles within a fifth of the drop's half-axes from its centre.
inline Measurement error_of_pressure(const reference::EllipticDrop& flow) {
  return [flow](const Level& level, const Run& run) {
    std::vector<Value> errors;
    for (const Samples& s : run.samples) {
      const auto state = flow.at(s.time);
      const double error = mean_where(
          s, [&](const Samples&, Eigen::Index p) { return s.pressure[p] - state.p(s.x(0, p), s.x(1, p)); },
          [&](const Vec2& x) { return !(Vec2(x.x() / state.a, x.y() / state.b).norm() > 0.2); });
      errors.push_back({level.name, level.spacing, s.time, pressure_error, 100 * error / flow.at(0).p_centre});
    }
    return errors;
  };
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
