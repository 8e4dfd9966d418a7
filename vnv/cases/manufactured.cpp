/// The manufactured solution (vnv/flows/manufactured.hpp). Few steps and no error floor other than rounding: the
/// strongest claims on the order are made here.

#include "vnv/flows/manufactured.hpp"
#include "vnv/studies/run_time.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::square;
using namespace touchstone::vnv::manufactured;

namespace {

const std::vector<Level> six_levels = levels_across(
    side,
    {{32, end, 0, end}, {48, end, 0, end}, {64, end, 0, end}, {96, end, 0, end}, {128, 0, 0, end}, {256, 0, 0, end}});
/// In MPM four particles share a node.
const std::vector<Level> finer_levels = levels_across(
    side,
    {{48, end, 0, end}, {72, end, 0, end}, {96, end, 0, end}, {144, end, 0, end}, {192, 0, 0, end}, {384, 0, 0, end}});
const std::vector<Level> coarse_levels = levels_across(side, {{32, end, 0, end}, {64, end, 0, end}, {128, 0, 0, end}});

Claim of_second_order(const Quantity& quantity, const std::string& words) {
  return order_at_least(ladder_across, quantity, 1.9, 1.75, theory(words))
      .of_formal_order(2)
      .at(end)
      .with_at_least_levels(5);
}

/// For the methods that do not converge here.
Claim no_worse_than(double percent) {
  return at_most(l2_velocity, percent, baseline("1.5 times the first measured value")).on("32 across").at(end);
}

}  // namespace

Case vnv::the_case() {
  const Flow flow = flow_named("manufactured");
  const auto scene = manufactured::scene();
  Case declared{
      .title = flow.title(),
      .description = flow.judged.description +
                     " Vortices cross the grid at 0.4 of their velocity; Reynolds number 100, Mach number 0.1. The "
                     "density varies by 4 %, which gives a pressure amplitude of 4 rho U². Continuity is satisfied "
                     "identically.",
      .times = flow.judged.times,
      .measurements = {velocity_errors(flow.velocity()), pressure_errors(flow.pressure())},
      .methods = {with_ladder(coarse_levels, mpm_as_printed(scene, output_interval), {no_worse_than(33)}),
                  with_ladder(coarse_levels, mpm_gimp(scene, output_interval), {no_worse_than(24)}),
                  with_ladder(coarse_levels, mpm_affine(scene, output_interval), {no_worse_than(15)}),
                  with_ladder(finer_levels, mpm_least_squares(scene, output_interval),
                              {of_second_order(l2_velocity, "fits and differences of second order")}),
                  with_ladder(coarse_levels, sph_as_printed(scene, output_interval), {no_worse_than(55)}),
                  with_ladder(coarse_levels, sph_transport_velocity(scene, output_interval),
                              {no_worse_than(27), parted_by_transport}),
                  with_ladder(six_levels, sph_second_order(scene, output_interval),
                              {of_second_order(l2_velocity, "fits of second degree")})},
      .plots = figures(end, l2_velocity, 100),
  };
  return with_work(std::move(declared), {.error = l2_velocity, .times = {end}, .length = side});
}
