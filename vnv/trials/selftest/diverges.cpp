/// Must fail, and say where: a time step eight times the Courant limit.

#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "vnv/flows/channels/driven_channel.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

Case vnv::the_case() {
  return {
      .title = "Divergence",
      .times = {1},
      .measurements = {},
      .methods = {{
          .name = "mpm",
          .run = mpm_with<mpm::PrescribedMotion>(driven_by(Uniform{{drive, 1 * mm}}), 200 * us),
          .levels = {{.name = "M1", .spacing = H / 40, .cell = H / 40, .acceptance = 1}},
      }},
  };
}
