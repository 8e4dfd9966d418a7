/// What an error costs in start-up plane Couette flow [Sun et al., section 3.2], at the paper's bulk modulus.

#include "reference/couette.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channel_run_time.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

constexpr double V = 0.1 * mm;  // m/s

const Scene<Newtonian> scene{
    .domain = {.box = gap, .periodic_x = true},
    .fluid = water,
    .filled = gap,
    .walls = {floor_at(0, no_slip()), ceiling_at(H, no_slip({V, 0}))},
};

const reference::Couette exact{.H = H, .V = V, .nu = water.kinematic_viscosity()};

}  // namespace

Case vnv::the_case() {
  const Claim as_m1 = at_most(price_of(work_diagram(), 1), 98,
                              literature("Sun et al., table 4, M1: 200000 steps of 0.49 ms for 1.08 %")),
              as_s1 = at_most(price_of(work_diagram(), 3), 944,
                              literature("Sun et al., table 4, S1: 200000 steps of 4.72 ms for 1.35 %"));
  Case declared = error_against_run_time_in(
      scene, exact, published_work("couette"),
      {{"mpm", {as_m1}},
       {"mpm_reset", {as_m1}},
       {"mpm_float", {as_m1}},
       {"mpm_affine", {as_m1}},
       {"sph_regularised_float", {as_s1}},
       {"sph_one_evaluation", {as_s1}},

       {"sph",
        {at_least(l2, 1.35, theory("an elastic lattice at any spacing and step: above Sun et al., table 4, S1"))
             .at(1)}},
       {"sph_difference", {as_s1}},
       {"sph_regularised", {as_s1}}});
  declared.title = "Couette flow: work-precision diagram";
  declared.description =
      "The start-up of plane Couette flow from rest to 1 s, at the paper's bulk modulus: each method over resolutions "
      "and over time steps, from the paper's 5 us up to nearly the longest that it can bear. At 1 s the exact profile is a "
      "straight line, which linear hats represent without error: where a method has the wall right its error is small "
      "on any grid.";
  return declared;
}
