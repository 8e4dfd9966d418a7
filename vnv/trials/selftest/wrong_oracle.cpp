/// Must fail: a right solver against an oracle of half the force.

#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "vnv/flows/channels/driven_channel.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

Case vnv::the_case() {
  const Truth half_the_force = flow_named("poiseuille", Settings({{"F", drive / 2}})).along_x();
  return {
      .title = "Wrong oracle",
      .times = {0.02},
      .measurements = {norms_of("v_x, per particle", by_particles, half_the_force)},
      .methods = {{
          .name = "mpm",
          .run = mpm_with<mpm::PrescribedMotion>(driven_by(Uniform{{drive, 0}})),
          .levels = {{.name = "coarse", .spacing = H / 20, .cell = H / 10, .acceptance = 0.02}},
          .claims = {at_most(l2, 10, theory("any right method"))},
      }},
  };
}
