/// Must fail: a right solver against an oracle of half the force.

#include "reference/poiseuille.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channel.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {
const Scene<Newtonian, Uniform> scene{
    .domain = {.box = gap, .periodic_x = true},
    .fluid = water,
    .filled = gap,
    .walls = {floor_at(0, no_slip()), ceiling_at(H, no_slip())},
    .body_force = {{8 * mm, 0}},
};
const reference::Poiseuille half_the_force{.H = H, .F = 4 * mm, .nu = water.kinematic_viscosity()};
}  // namespace

Case vnv::the_case() {
  return {
      .title = "Wrong oracle",
      .times = {0.02},
      .measurements = {norms_of("v_x, per particle", by_particles, half_the_force)},
      .methods = {{
          .name = "mpm",
          .run = mpm_with<mpm::PrescribedMotion>(scene),
          .levels = {{.name = "coarse", .spacing = H / 20, .cell = H / 10, .acceptance = 0.02}},
          .claims = {at_most(l2, 10, theory("any right method"))},
      }},
  };
}
