/// Decaying Taylor-Green vortices at a Reynolds number of 100 [Taylor 1923]. Their strain distorts any lattice of
/// particles within a tenth of their lifetime: the hardest of the smooth flows for a particle method.

#include "vnv/flows/taylor_green.hpp"
#include "vnv/studies/run_time.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::taylor_green;

namespace {

/// Of the methods of second order: how energy decays and, once the flow has begun to tear the lattice, the order.
/// Levels stand close to each other, since the error of a method that remeshes or spreads particles falls unevenly.
std::vector<Claim> claims_of_second_order(const Claim& order) {
  std::vector<Claim> claims = {order.at(early).with_at_least_levels(6)};
  for (const auto& [level, limit] : {std::pair("50 across", 1.0), std::pair("100 across", 0.3)})
    claims.push_back(between(decay_error, -limit, limit, baseline("goal for " + std::string(level))).on(level).at(end));
  return claims;
}
Claim of_least_squares() {
  return order_at_least(ladder_across, l2_velocity, 1.8, 1.5, theory("second order")).of_formal_order(2);
}

/// Of order three at first and 1.4 in the end, which a fit takes for a floor of 0.002 %. It is none: with 140 and 200
/// across the error is 0.0036 and 0.0022 %; and not the Mach number's doing: a fluid of twice the speed of sound is
/// wrong by 0.0040 % with 140.
Claim of_sph() {
  return order_between(ladder_across, l2_velocity, 1.8, 4, theory("second order or more")).of_formal_order(2);
}

/// For the methods that do not converge here.
Claim no_worse_than(double percent) {
  return at_most(l2_velocity, percent, baseline("1.5 times the first measured value")).on("50 across").at(early);
}

}  // namespace

Case vnv::the_case() {
  const Flow flow = flow_named("taylor_green");
  Case declared = taylor_green::declared(flow,
                                         {{50, early, 0, end},
                                          {60, 0, 0, early},
                                          {70, early, 0, early},
                                          {84, 0, 0, early},
                                          {100, 0, 0, end},
                                          {120, 0, 0, early},
                                          {140, 0, 0, early}},
                                         {{"mpm", {no_worse_than(77)}},
                                          {"mpm_affine", {no_worse_than(17)}},
                                          {"mpm_least_squares", claims_of_second_order(of_least_squares())},
                                          {"sph", {no_worse_than(92)}},
                                          {"sph_transport_velocity", {no_worse_than(15)}},
                                          {"sph_second_order", claims_of_second_order(of_sph())}});
  declared.methods.back().tolerance = {
      0.1, "particles are redistributed: a sanitized build differed by 5 % in pressure"};  // they return to no lattice
  declared.description +=
      " Here the Reynolds number is 100 and the Mach number 1/80. Within half a second the flow stretches the fluid "
      "near the corners of the vortices ten times.";
  return with_work(std::move(declared), {.error = l2_velocity,
                                         .times = {end},
                                         .length = square::side,
                                         .largest_speed = flow["U"],
                                         .stiffness = {80, 40, 20, 10},
                                         .budget = 30});
}
