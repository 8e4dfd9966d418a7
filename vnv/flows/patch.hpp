#pragma once
/// A square patch of an inviscid fluid that begins to rotate as if rigid, in nothing [Colagrossi 2005].

#include "reference/rotating_patch.hpp"
#include "vnv/methods/free_surface_methods.hpp"

namespace touchstone::vnv::patch {

inline constexpr double L = 1, omega = 1, rho0 = 1000, c = 20;  // m, 1/s, kg/m³, m/s
inline constexpr double output_interval = 0.1;                  // s  of which every step divides the times
inline const reference::RotatingPatch exact{.L = L, .omega = omega, .rho = rho0};

inline Vec2 velocity(const Vec2& x, double /*t*/) { return {exact.v_x(x.y()), exact.v_y(x.x())}; }
inline double pressure(const Vec2& x, double /*t*/) { return exact.p(x.x(), x.y()); }

inline Scene<Tait> scene() {
  return {.domain = {.box = {.low = {-1.5, -1.5}, .high = {1.5, 1.5}}},
          .fluid = {.density = rho0, .bulk_modulus = rho0 * c * c / 7},
          .filled = {.low = {-L / 2, -L / 2}, .high = {L / 2, L / 2}},
          .start = {.velocity = [](const Vec2& x) { return velocity(x, 0); },
                    .pressure = [](const Vec2& x) { return pressure(x, 0); }}};
}

// The methods that run it, for a scene.
inline Method printed(const Scene<Tait>& seen) { return mpm_as_printed(seen, output_interval, 0.4); }
inline Method apic(const Scene<Tait>& seen) { return mpm_apic(seen, output_interval); }
inline Method delta(const Scene<Tait>& seen) { return sph_delta(seen, output_interval); }
inline Method shifted(const Scene<Tait>& seen) { return sph_shifted(seen, output_interval); }

}  // namespace touchstone::vnv::patch
