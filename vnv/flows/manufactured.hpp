#pragma once
/// A flow in a periodic square that was chosen so that every term of the equations of motion takes part, sustained by
/// a body force (reference/manufactured.hpp).

#include "reference/manufactured.hpp"
#include "solvers/forces/force_field.hpp"
#include "vnv/flows/square.hpp"
#include "vnv/measures/coverage.hpp"
#include "vnv/studies/views.hpp"

namespace touchstone::vnv::manufactured {

/// Its parameters; those that are set are those of the case.
struct Chosen {
  double L = square::side, U = 1, omega = 5, ripple = 0.02;  // m, m/s, 1/s, -
  double rho0 = 1000, c = 10, Re = 100;                      // kg/m³, m/s, -

  constexpr Newtonian fluid() const {
    return {{.density = rho0, .bulk_modulus = rho0 * c * c / Tait::gamma}, rho0 * U * L / Re};
  }
  constexpr reference::Manufactured exact() const {
    return {L, U, omega, rho0, ripple, fluid().bulk_modulus, fluid().viscosity};
  }
};
inline constexpr Newtonian fluid = Chosen{}.fluid();
inline constexpr reference::Manufactured exact = Chosen{}.exact();

inline VelocityTruth velocity_of(const reference::Manufactured& flow) {
  return [flow](const Vec2& x, double t) -> Vec2 { return Vec2(flow.velocity(x.x(), x.y(), t).data()); };
}
inline PressureTruth pressure_of(const reference::Manufactured& flow) {
  return [flow](const Vec2& x, double) { return flow.pressure(x.x(), x.y()); };
}
inline const VelocityTruth velocity = velocity_of(exact);
inline const PressureTruth pressure = pressure_of(exact);

struct Sustaining {
  View seen = views::plain();

  Vec2 operator()(const Vec2& x, double t) const {
    const Vec2 place = seen.place_in_plain_flow(x, t);
    const auto b = exact.force(place.x(), place.y(), t);
    return seen.turned * Vec2(b[0], b[1]);
  }
};

inline constexpr double end = 0.2;  // s  a fifth of L / U
inline const Scene<Newtonian, ForceField> scene{.domain = square::domain,
                                                .fluid = fluid,
                                                .filled = square::box,
                                                .body_force = {Sustaining{}},
                                                .start = {.velocity = [](const Vec2& x) { return velocity(x, 0); },
                                                          .pressure = [](const Vec2& x) { return pressure(x, 0); }}};

/// Of a transport velocity, which carries particles otherwise than the fluid moves: where the flow draws them apart they
/// are fewer than the fluid there, 5.0 spacings on the disturbed lattice with 34 across.
inline const Claim parted_by_transport =
    at_most(largest_hole, 7.5, baseline("1.5 times the first measured value: it does not move with the fluid")).at(end);

}  // namespace touchstone::vnv::manufactured
