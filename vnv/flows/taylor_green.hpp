#pragma once
/// Decaying Taylor-Green vortices [Taylor 1923] in a periodic square of 1 m, at any Reynolds number.

#include "reference/taylor_green.hpp"
#include "vnv/flows/square.hpp"
#include "vnv/measures/decay.hpp"
#include "vnv/plots/over_time.hpp"

namespace touchstone::vnv::taylor_green {

inline constexpr double U = 1, rho = 1000;  // m/s, kg/m³

/// The flow at a Reynolds number U L / nu and a speed of sound [m/s].
struct Flow {
  double reynolds, sound_speed;

  Newtonian fluid() const {
    return {{.density = rho, .bulk_modulus = rho * sound_speed * sound_speed / 7}, rho * U * square::side / reynolds};
  }
  reference::TaylorGreen exact() const {
    return {.L = square::side, .U = U, .nu = fluid().kinematic_viscosity(), .rho = rho};
  }
  VelocityTruth velocity() const {
    return [flow = exact()](const Vec2& x, double t) -> Vec2 {
      return {flow.v_x(x.x(), x.y(), t), flow.v_y(x.x(), x.y(), t)};
    };
  }
  PressureTruth pressure() const {
    return [flow = exact()](const Vec2& x, double t) { return flow.p(x.x(), x.y(), t); };
  }
  Scene<Newtonian> scene() const {
    return {.domain = square::domain,
            .fluid = fluid(),
            .filled = square::box,
            .start = {.velocity = [v = velocity()](const Vec2& x) { return v(x, 0); },
                      .pressure = [p = pressure()](const Vec2& x) { return p(x, 0); }}};
  }
};

/// What its cases share: errors at `early` and the decay of energy until `end`, by methods of which those of second
/// order have their own levels.
inline constexpr double early = 0.1, end = 0.5;  // s
inline Case declared(const Flow& flow, const std::vector<Across>& of_second_order,
                     const std::map<std::string, std::vector<Claim>>& claims = {}) {
  const reference::TaylorGreen exact = flow.exact();
  Case all{.times = {early, end},
           .monitor = kinetic_energy_every(0.01),
           .measurements = {velocity_errors(flow.velocity()), pressure_errors(flow.pressure()),
                            decay_of_energy(0, 2 * exact.decay_rate())},
           .methods = with_ladder(levels_across(square::side, {{50, early, 0, end}, {100, 0, 0, end}}),
                                  square::methods_on(flow.scene()), claims),
           .plots = {kinetic_energy_over_time(0, {"50 across"}),
                     exact_over_time(
                         "energy", [exact](double t) { return exact.energy(t); }, end)},
           .priced_as = "taylor_green"};
  for (Method& method : all.methods)
    if (method.name == "mpm_least_squares" || method.name == "sph_second_order")
      method = with_ladder(levels_across(square::side, of_second_order), method, method.claims);
  return with_plots(std::move(all), square::figures(early, l2_velocity, 50));
}

}  // namespace touchstone::vnv::taylor_green
