/// Work-precision diagram of start-up plane Couette flow [Sun et al., section 3.2], at the paper's bulk modulus.

#include "vnv/flows/channels/channel_run_time.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

Case vnv::the_case() {
  const Flow couette = flow_named("couette");
  const WorkStudy study = start_up_study(couette["V"]);
  const Claim as_m1 = at_most(price_of(study.diagram(), 1), 98,
                              literature("Sun et al., table 4, M1: 200000 steps of 0.49 ms for 1.08 %")),
              as_s1 = at_most(price_of(study.diagram(), 3), 944,
                              literature("Sun et al., table 4, S1: 200000 steps of 4.72 ms for 1.35 %"));
  return error_against_run_time_in<NoForce>(
      "Couette flow: work-precision diagram",
      "The start-up of plane Couette flow from rest to 1 s, at the paper's bulk modulus: each method is run over "
      "resolutions, points per cell or smoothing lengths, and time steps up to beyond the largest stable one. At 1 s "
      "the exact profile is a straight line, which linear shape functions represent exactly, so that the larger of the "
      "errors at 0.1 and 1 s counts.",
      couette, study, published_work(couette.name),
      {{"mpm", {as_m1}}, {"sph_difference", {as_s1}}, {"sph_regularised", {as_s1}}});
}
