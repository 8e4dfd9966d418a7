/// A flow that was chosen so that every term of the equations of motion takes part, sustained by a body force
/// (reference/manufactured.hpp). Few steps and no floor but rounding: here the strongest claims of order are made.

#include "reference/manufactured.hpp"
#include "vnv/square.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::square;

namespace {

constexpr double end = 0.2;  // s

constexpr double rho0 = 1000, c = 10;  // kg/m³, m/s
constexpr Newtonian fluid{{.density = rho0, .bulk_modulus = rho0 * c * c / 7}, 10};
constexpr reference::Manufactured exact{
    .L = side, .U = 1, .omega = 5, .rho0 = rho0, .ripple = 0.02, .K = fluid.bulk_modulus, .mu = fluid.viscosity};

Vec2 velocity(const Vec2& x, double t) {
  const auto v = exact.velocity(x.x(), x.y(), t);
  return {v[0], v[1]};
}
double pressure(const Vec2& x, double /*t*/) { return exact.pressure(x.x(), x.y()); }

struct Sustaining {
  Vec2 operator()(const Vec2& x, double t) const {
    const auto b = exact.force(x.x(), x.y(), t);
    return {b[0], b[1]};
  }
};

const Scene<Newtonian, Sustaining> scene{.domain = domain,
                                         .fluid = fluid,
                                         .filled = box,
                                         .body_force = {},
                                         .start = {.velocity = [](const Vec2& x) { return velocity(x, 0); },
                                                   .pressure = [](const Vec2& x) { return pressure(x, 0); }}};

const std::vector<Rung> six_levels = rungs(
    {{32, end, 0, end}, {48, end, 0, end}, {64, end, 0, end}, {96, end, 0, end}, {128, 0, 0, end}, {256, 0, 0, end}});
/// In MPM four particles share a node.
const std::vector<Rung> finer_levels = rungs(
    {{48, end, 0, end}, {72, end, 0, end}, {96, end, 0, end}, {144, end, 0, end}, {192, 0, 0, end}, {384, 0, 0, end}});
const std::vector<Rung> coarse_levels = rungs({{32, end, 0, end}, {64, end, 0, end}, {128, 0, 0, end}});

Claim of_second_order(const std::string& quantity, const std::string& words) {
  return order_at_least(ladder, quantity, 1.9, 1.75, theory(words)).at(end).over(5);
}

/// For the methods that do not converge here.
Claim no_worse_than(double percent) {
  return at_most(l2_velocity, percent, baseline("half as much again as first measured")).on("32 across").at(end);
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "A manufactured solution",
      .description =
          "A flow in a periodic square of 1 m, unsteady, compressed and stretched, which crosses the grid at 0.4 m/s and "
          "turns in vortices of 1 m/s; Reynolds number 100, Mach number 0.1. Its density varies by 4 %, which is a pressure of 4 "
          "rho U². A body force sustains it exactly; continuity holds by itself.",
      .times = {end},
      .measurements = {velocity_errors(velocity), pressure_errors(pressure)},
      .methods =
          {
              {.name = "mpm",
               .description = mpm_words,
               .run = mpm_as_printed(scene),
               .rungs = coarse_levels,
               .ladders = ladders(coarse_levels),
               .claims = {no_worse_than(33)},
               .tolerance = stretched},
              {.name = "mpm_affine",
               .description = affine_words,
               .run = mpm_affine(scene),
               .rungs = coarse_levels,
               .ladders = ladders(coarse_levels),
               .claims = {no_worse_than(15)},
               .tolerance = stretched},
              {.name = "mpm_least_squares",
               .description = least_squares_words,
               .run = mpm_least_squares(scene),
               .rungs = finer_levels,
               .ladders = ladders(finer_levels),
               .claims = {of_second_order(l2_velocity, "fits and differences of second order")},
               .tolerance = stretched},
              {.name = "sph",
               .description = sph_words,
               .run = sph_as_printed(scene),
               .rungs = coarse_levels,
               .ladders = ladders(coarse_levels),
               .claims = {no_worse_than(55)},
               .tolerance = stretched},
              {.name = "sph_transport_velocity",
               .description = transport_words,
               .run = sph_transport_velocity(scene),
               .rungs = coarse_levels,
               .ladders = ladders(coarse_levels),
               .claims = {no_worse_than(27)},
               .tolerance = stretched},
              {.name = "sph_second_order",
               .description = second_order_words,
               .run = sph_second_order(scene),
               .rungs = six_levels,
               .ladders = ladders(six_levels),
               .claims = {of_second_order(l2_velocity, "fits of second degree")},
               .tolerance = stretched},
          },
      .plots = figures(end, l2_velocity, 100),
  };
}
