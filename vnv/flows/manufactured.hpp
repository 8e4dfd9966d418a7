#pragma once
/// A flow in a periodic square that was chosen so that every term of the equations of motion takes part, sustained by
/// a body force (reference/manufactured.hpp).

#include "reference/manufactured.hpp"
#include "solvers/forces/force_field.hpp"
#include "vnv/flows/square.hpp"
#include "vnv/studies/views.hpp"

namespace touchstone::vnv::manufactured {

inline constexpr double rho0 = 1000, c = 10;  // kg/m³, m/s
inline constexpr Newtonian fluid{{.density = rho0, .bulk_modulus = rho0 * c * c / 7}, 10};
inline constexpr reference::Manufactured exact{.L = square::side,
                                               .U = 1,
                                               .omega = 5,
                                               .rho0 = rho0,
                                               .ripple = 0.02,
                                               .K = fluid.bulk_modulus,
                                               .mu = fluid.viscosity};

inline Vec2 velocity(const Vec2& x, double t) {
  const auto v = exact.velocity(x.x(), x.y(), t);
  return {v[0], v[1]};
}
inline double pressure(const Vec2& x, double /*t*/) { return exact.pressure(x.x(), x.y()); }

struct Sustaining {
  View seen = views::plain();

  Vec2 operator()(const Vec2& x, double t) const {
    const Vec2 place = seen.place_in_plain_flow(x, t);
    const auto b = exact.force(place.x(), place.y(), t);
    return seen.turned * Vec2(b[0], b[1]);
  }
};

inline constexpr double end = 0.2;  // s
inline const Scene<Newtonian, ForceField> scene{.domain = square::domain,
                                                .fluid = fluid,
                                                .filled = square::box,
                                                .body_force = {Sustaining{}},
                                                .start = {.velocity = [](const Vec2& x) { return velocity(x, 0); },
                                                          .pressure = [](const Vec2& x) { return pressure(x, 0); }}};

}  // namespace touchstone::vnv::manufactured
