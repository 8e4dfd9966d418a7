#pragma once
/// A square patch of an inviscid fluid that begins to rotate as if rigid, in nothing [Colagrossi 2005].

#include "reference/rotating_patch.hpp"
#include "vnv/flows/flow.hpp"
#include "vnv/judge/norms.hpp"
#include "vnv/measures/decay.hpp"
#include "vnv/measures/half_axes.hpp"
#include "vnv/measures/roughness.hpp"
#include "vnv/methods/free_surface_methods.hpp"

namespace touchstone::vnv::patch {

inline constexpr double L = 1, omega = 1, rho0 = 1000, c = 20;  // m, 1/s, kg/m³, m/s
inline constexpr double output_interval = 0.1;                  // s  of which every step divides the times
inline const reference::RotatingPatch exact{.L = L, .omega = omega, .rho = rho0};

inline Vec2 velocity(const Vec2& x, double /*t*/) { return {exact.v_x(x.y()), exact.v_y(x.x())}; }
inline double pressure(const Vec2& x, double /*t*/) { return exact.p(x.x(), x.y()); }

inline Scene<Tait> scene_with(const reference::RotatingPatch& flow, double sound_speed) {
  const Vec2 far = Vec2::Constant(1.5 * flow.L), corner = Vec2::Constant(flow.L / 2);
  return {.domain = {.box = {.low = -far, .high = far}},
          .fluid = {.density = flow.rho, .bulk_modulus = flow.rho * sound_speed * sound_speed / Tait::gamma},
          .filled = {.low = -corner, .high = corner},
          .start = {.velocity = [flow](const Vec2& x) -> Vec2 {
                      return {flow.v_x(x.y()), flow.v_y(x.x())};
                    },
                    .pressure = [flow](const Vec2& x) { return flow.p(x.x(), x.y()); }}};
}
inline Scene<Tait> scene() { return scene_with(exact, c); }

/// Columns of what is monitored.
enum Monitored : std::size_t { momentum_x, momentum_y, angular_momentum, energy, longer, shorter, middle };

/// Mean pressure [Pa] over the particles within a tenth of a side [m] from the middle.
inline double pressure_in_the_middle(const Samples& s, double side) {
  return mean_where(s, vnv::pressure, [side](const Vec2& x) { return x.norm() < 0.1 * side; });
}

inline Monitor monitored(double side) {
  return {.interval = 0.02,
          .evaluate = [side](const Samples& s) -> std::vector<double> {
            const auto axes = half_axes(s);
            const Vec2 momentum = s.v * s.mass.matrix();
            const double L_z = vnv::angular_momentum(s);
            return {momentum.x(),
                    momentum.y(),
                    L_z,
                    kinetic_energy(s),
                    axes.longer,
                    axes.shorter,
                    pressure_in_the_middle(s, side)};
          },
          .quantities = {{"momentum along x", "kg/s"},
                         {"momentum along y", "kg/s"},
                         {"angular momentum", "kg m/s"},
                         {"kinetic energy", "J/m"},
                         {"longer half-axis", "m"},
                         {"shorter half-axis", "m"},
                         {"pressure in the middle", "Pa"}}};
}

inline const Quantity drift{"largest change of momentum over m omega L", "", Kind::invariant},
    angular_momentum_error{"largest relative change of angular momentum", "%", Kind::invariant},
    loss{"relative loss of kinetic energy", "%", Kind::invariant},
    asymmetry{"relative difference of the half-axes from second moments", "%", Kind::invariant};

/// The last of them only where it is asked for.
inline Measurement conservation_errors(const reference::RotatingPatch& flow,
                                       std::function<bool(const Level&)> asks_for_asymmetry) {
  return [=](const Level& level, const Run& run) -> std::vector<Value> {
    if (!run.summary.finished) return {};
    const std::vector<double>&first = run.history.values.front(), &last = run.history.values.back();
    double largest = 0, farthest = 0;
    for (const std::vector<double>& row : run.history.values) {
      largest = norms::larger_magnitude(
          largest, std::hypot(row[momentum_x] - first[momentum_x], row[momentum_y] - first[momentum_y]));
      farthest = norms::larger_magnitude(farthest, row[angular_momentum] / first[angular_momentum] - 1);
    }
    const auto at_the_end = [&](const Quantity& quantity, double value) {
      return Value{level.name, level.spacing, run.summary.end_time, quantity, value};
    };
    std::vector<Value> found = {at_the_end(drift, largest / (flow.mass() * flow.omega * flow.L)),
                                at_the_end(angular_momentum_error, 100 * std::abs(farthest)),
                                at_the_end(loss, 100 * (1 - last[energy] / first[energy]))};
    if (asks_for_asymmetry(level)) found.push_back(at_the_end(asymmetry, 100 * (last[longer] / last[shorter] - 1)));
    return found;
  };
}

inline Measurement central_pressure(const reference::RotatingPatch& flow) {
  return [=](const Level& level, const Run& run) {
    std::vector<Value> found;
    for (const Samples& s : run.samples)
      found.push_back({level.name,
                       level.spacing,
                       s.time,
                       {"central pressure over that at the start"},
                       pressure_in_the_middle(s, flow.L) / flow.p(0, 0)});
    return found;
  };
}

inline Measurement roughness_of_pressure(const reference::RotatingPatch& flow) {
  return roughness_of("pressure", vnv::pressure, "rho omega² L²", flow.rho * flow.omega * flow.omega * flow.L * flow.L);
}

// The methods that run it, for a scene.
inline Method printed(const Scene<Tait>& seen) { return mpm_as_printed(seen, output_interval, 0.4); }
inline Method apic(const Scene<Tait>& seen) { return mpm_apic(seen, output_interval); }
inline Method delta(const Scene<Tait>& seen) { return sph_delta(seen, output_interval); }
inline Method shifted(const Scene<Tait>& seen) { return sph_shifted(seen, output_interval); }

}  // namespace touchstone::vnv::patch
