/// Must fail, and say where: a time step eight times the Courant limit.

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
    .body_force = {{8 * mm, 1 * mm}},
};
}  // namespace

Case vnv::the_case() {
  return {
      .title = "Divergence",
      .times = {1},
      .measurements = {},
      .methods = {{
          .name = "mpm",
          .run = mpm_with<mpm::PrescribedMotion>(scene, 200 * us),
          .levels = {{.name = "M1", .spacing = H / 40, .cell = H / 40, .acceptance = 1}},
      }},
  };
}
