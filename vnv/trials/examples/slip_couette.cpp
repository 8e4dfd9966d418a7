/// Couette flow between a plate and one over which the fluid slides: an example of a case, with a kernel, a wall and a
/// method of its own.

#include "solvers/sph/second_order/second_order.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channels/channel.hpp"
#include "vnv/methods/across.hpp"
#include "vnv/trials/examples/sliding_slip.hpp"
#include "vnv/trials/examples/wendland_c6.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

constexpr double V = 1 * mm, b = H / 4, end = 0.05;  // m/s, m, s

/// The fluid starts with the steady profile V y / (H + b), and keeps it.
double exact(double y, double /*t*/) { return V * y / (H + b); }

const Scene<Newtonian> scene{
    .domain = {.box = gap, .periodic_x = true},
    .fluid = water,
    .filled = gap,
    .walls = {floor_at(0, no_slip()), ceiling_at(H, sliding_slip({V, 0}, b))},
    .start = {.velocity = [](const Vec2& x) -> Vec2 {
      return {exact(x.y(), 0), 0};
    }},
};

Method on_wendland_c6() {
  return simulating(
      {.name = "sph_wendland_c6",
       .family = Family::sph,
       .description = "SPH of second order on Wendland's C6 kernel, h = 1.6 spacings, acoustic Courant number 0.3."},
      [](const Level& level, double time_step) {
        return sph::second_order<sph::WendlandC6>(
            scene, {.spacing = level.spacing, .smoothing_length = 1.6 * level.spacing, .time_step = time_step});
      },
      [](const Level& level) { return step_for(scene, 0.3, level.spacing, end); });
}

}  // namespace

Case vnv::the_case() {
  const Claim keeps_the_profile = at_most(l2, 0.01, theory("fits of second degree are exact for a linear profile"));
  return {.title = "Couette flow with slip",
          .times = {end},
          .measurements = {norms_of("v_x, per particle", by_particles, exact)},
          .methods = {with_ladder(levels_across(H, {{20, end, 0, 0}, {28, end, 0, 0}}), on_wendland_c6(),
                                  {keeps_the_profile.at(end)})}};
}
