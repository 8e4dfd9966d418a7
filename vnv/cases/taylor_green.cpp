/// Decaying Taylor-Green vortices at a Reynolds number of 100 [Taylor 1923]. Their stretching tears any lattice of
/// particles within a tenth of the time that they live: the hardest of the smooth flows for a particle method.

#include "reference/taylor_green.hpp"
#include "vnv/measures/decay.hpp"
#include "vnv/plots/over_time.hpp"
#include "vnv/square.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::square;

namespace {

constexpr double early = 0.1, end = 0.5;               // s
constexpr double U = 1, c = 80, rho = 1000, Re = 100;  // m/s, m/s, kg/m³, -
constexpr Newtonian fluid{{.density = rho, .bulk_modulus = rho * c * c / 7}, rho* U* side / Re};
const reference::TaylorGreen exact{.L = side, .U = U, .nu = fluid.kinematic_viscosity(), .rho = rho};

Vec2 velocity(const Vec2& x, double t) { return {exact.v_x(x.x(), x.y(), t), exact.v_y(x.x(), x.y(), t)}; }
double pressure(const Vec2& x, double t) { return exact.p(x.x(), x.y(), t); }

const Scene<Newtonian> scene{.domain = domain,
                             .fluid = fluid,
                             .filled = box,
                             .start = {.velocity = [](const Vec2& x) { return velocity(x, 0); },
                                       .pressure = [](const Vec2& x) { return pressure(x, 0); }}};

const std::vector<Rung> finely =
    rungs({{50, early, 0, end}, {70, early, 0, early}, {100, 0, 0, end}, {140, 0, 0, early}, {200, 0, 0, early}});
const std::vector<Rung> coarsely = rungs({{50, early, 0, end}, {100, 0, 0, end}});

std::vector<Claim> claims_of_decay() {
  std::vector<Claim> claims;
  for (const auto& [rung, limit] : {std::pair("50 across", 1.0), std::pair("100 across", 0.3)})
    claims.push_back(between(decay_error, -limit, limit, baseline("goal for " + std::string(rung))).on(rung).at(end));
  return claims;
}

/// For the methods that do not converge here.
Claim no_worse_than(double percent) {
  return at_most(l2_velocity, percent, baseline("half as much again as first measured")).on("50 across").at(early);
}

}  // namespace

Case vnv::the_case() {
  Case declared{
      .title = "Taylor-Green vortices",
      .description =
          "Four vortices in a periodic square of 1 m decay; top speed 1 m/s at the start, Reynolds number 100, Mach number "
          "1/80. The oracle is Taylor's solution for an incompressible fluid. Within half a second the flow stretches fluid at "
          "the corners of the vortices ten times.",
      .times = {early, end},
      .watch = {.every = 0.01, .see = [](const Samples& s) { return std::vector{kinetic_energy(s)}; }},
      .measurements = {velocity_errors(velocity), pressure_errors(pressure),
                       decay_of_energy(0, 2 * exact.decay_rate())},
      .methods =
          {
              {.name = "mpm",
               .description = mpm_words,
               .run = mpm_as_printed(scene),
               .rungs = coarsely,
               .ladders = ladders(coarsely),
               .claims = {no_worse_than(77)},
               .tolerance = stretched},
              {.name = "mpm_affine",
               .description = affine_words,
               .run = mpm_affine(scene),
               .rungs = coarsely,
               .ladders = ladders(coarsely),
               .claims = {no_worse_than(17)},
               .tolerance = stretched},
              {.name = "mpm_least_squares",
               .description = least_squares_words,
               .run = mpm_least_squares(scene),
               .rungs = finely,
               .ladders = ladders(finely),
               .claims = claims_of_decay(),
               .tolerance = stretched},
              {.name = "sph",
               .description = sph_words,
               .run = sph_as_printed(scene),
               .rungs = coarsely,
               .ladders = ladders(coarsely),
               .claims = {no_worse_than(92)},
               .tolerance = stretched},
              {.name = "sph_transport_velocity",
               .description = transport_words,
               .run = sph_transport_velocity(scene),
               .rungs = coarsely,
               .ladders = ladders(coarsely),
               .claims = {no_worse_than(15)},
               .tolerance = stretched},
              {.name = "sph_second_order",
               .description = second_order_words,
               .run = sph_second_order(scene),
               .rungs = finely,
               .ladders = ladders(finely),
               .claims = claims_of_decay(),
               .tolerance = stretched},
          },
      .plots = {over_time({"energy", "Kinetic energy", "Of all particles.", {"t [s]"}, {"kinetic energy [J/m]"}}, 0,
                          {"50 across"}),
                exact_over_time(
                    "energy", [](double t) { return exact.energy(t); }, end)},
  };
  return with_plots(std::move(declared), figures(early, l2_velocity, 50));
}
