/// Start-up of plane Poiseuille flow [Sun et al., section 3.1]. Water at rest between two plates is subject to a body
/// force along x from t = 0; at 1 s the profile is the steady parabola to four digits.

#include "vnv/flows/channels/start_up.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

const PaperFlow flow{.name = "poiseuille",
                     .table = 3,
                     .figure = 5,
                     .monitored = "Maximum velocity",
                     .nightly_of_M2 = 10,
                     .report_of_S3 = 1};

double largest_velocity(const Samples& samples) { return samples.v.row(0).maxCoeff(); }

std::map<std::string, std::vector<Claim>> claims() {
  const Author second_order = theory("linear shape functions, central quadrature: order 2");
  return {
      {"mpm",
       {at_most(l2, 0.07, baseline("an independent prototype of the same scheme gave 0.064")).on("M2").at(1),
        at_most(linf, 0.08, baseline("an independent prototype of the same scheme gave 0.068")).on("M2").at(1),
        order_between(grid, l2, 1.9, 2.1, second_order).of_formal_order(2).at(1),
        order_between(grid, linf, 1.9, 2.1, second_order).of_formal_order(2).at(1)}},
      {"mpm_reset", {near_the_papers(flow, "M1")}},
      {"sph",
       {at_most_the_papers(flow, "S1"), at_most_the_papers(flow, "S2"), at_most_the_papers(flow, "S3"),
        order_between(spacing_ladder, l2_rows, 0, 0.5, baseline("stalls: the lattice is elastic at any spacing"))
            .at(1)}},
      {"sph_regularised",
       {at_most(l2, 0.5, baseline("a prototype with mirrored wall velocities gave 0.39")).on("S1").at(1),
        at_most(l2, 0.5, baseline("the same at 10 s")).on("S1").at(10)}}};
}

}  // namespace

Case vnv::the_case() {
  const auto scene = scene_of<Newtonian, Uniform>(flow_named(flow.name));
  return start_up_case(flow, largest_velocity, start_up_methods(scene, flow), claims());
}
