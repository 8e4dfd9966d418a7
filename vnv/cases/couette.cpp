/// Start-up of plane Couette flow [Sun et al., section 3.2]. Water at rest between two plates, of which the upper one
/// slides at a constant velocity from t = 0; at 1 s the profile is the straight line to four digits.

#include "vnv/flows/channels/start_up.hpp"

#include <cmath>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

const PaperFlow flow{.name = "couette", .table = 4, .figure = 8, .monitored = "Centreline velocity"};

/// L2 [%] of steady flow whose rows of particles are alternately too fast and too slow, by as much as the flow gains
/// over half a cell: what a reset wall leaves with one particle per cell (see mpm::VelocityReset).
const double alternating = 100 * std::sqrt(3) * (H / 40) / (2 * H);

/// Mean velocity of the rows within a fortieth of the gap around the middle.
double middle_velocity(const Samples& samples) {
  return mean_where(samples, velocity_x, [](const Vec2& x) { return std::abs(x.y() - H / 2) < H / 40; });
}

/// Kept to show that the suite detects it.
Method mpm_unfelt(const Scene<Newtonian>& scene) {
  return {.name = "mpm_unfelt",
          .family = Family::mpm,
          .description = mpm_words +
                         "Here a wall node has the velocity of the wall but transmits no acceleration: particles next "
                         "to a wall that starts impulsively never feel the start. Kept to show that the suite detects "
                         "this.",
          .run = mpm_with<mpm::PrescribedVelocity>(scene),
          .levels = {{.name = "M2", .spacing = H / 80, .cell = H / 40, .acceptance = 0.1, .report = 1, .nightly = 1}},
          .claims = {at_least(l2, 5, theory("the impulse of the wall is missing")).on("M2").at(0.1)}};
}

std::map<std::string, std::vector<Claim>> claims() {
  return {
      {"mpm",
       {at_most(l2, 0.04, baseline("an independent prototype of the same scheme gave 0.03")).on("M2").at(0.1),
        at_most_the_papers(flow, "M2"),
        order_between(grid, l2, 1.8, 2.3, theory("linear hats, central quadrature: order 2"))
            .of_formal_order(2)
            .at(0.1)}},
      {"mpm_reset",
       {between(l2_rows, 0.99 * alternating, 1.01 * alternating,
                theory("rows alternate by V cell / 2H, invisible to every node; table 4 gives 1.08 % for M1"))
            .on("M1")
            .at(1)}},
      {"sph",
       {between(l2_rows, 1.35, 5, literature("an elastic particle lattice: above Sun et al., table 4, S1"))
            .on("S1")
            .at(1),
        order_between(spacing_ladder, l2_rows, -0.6, 0,
                      baseline("the error grows: the lattice is elastic at any spacing"))
            .at(1)
            .with_at_least_levels(3)}},
      {"sph_regularised",
       {at_most(l2, 0.2, baseline("the regularised method is required to stay within 0.2 %")).on("S1").at(1),
        at_most(l2, 0.2, baseline("the same at 10 s")).on("S1").at(10)}}};
}

}  // namespace

Case vnv::the_case() {
  const auto scene = scene_of<Newtonian>(flow_named(flow.name));
  std::vector<Method> methods = start_up_methods(scene, flow);
  methods.insert(methods.begin() + 2, mpm_unfelt(scene));
  return start_up_case(flow, middle_velocity, std::move(methods), claims());
}
