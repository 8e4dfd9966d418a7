/// A circular drop in a straining flow [Monaghan 1994]: a closed free surface and no external force.

#include "vnv/flows/drop.hpp"
#include "vnv/measures/plots/along_ladders.hpp"
#include "vnv/measures/plots/over_time.hpp"
#include "vnv/studies/run_time.hpp"

#include <fmt/format.h>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::drop;

namespace {

const std::vector<Level> levels =
    levels_across(2 * R, {{40, end, 0, end}, {60, 0, 0, end}, {80, 0, 0, end}, {120, 0, 0, end}});

std::map<std::string, std::vector<Claim>> claims() {
  const Claim holds_its_shape =
      at_most(axes_error, 0.5, baseline("half-axes within 0.5 % are expected until the length has doubled"));
  const Claim converges =
      order_at_least(ladder_across, axes_error, 1, 0.75, theory("the free surface is resolved to one cell"))
          .with_at_least_levels(4);
  return {{"mpm_affine", {holds_its_shape, converges}},
          {"mpm_apic", {holds_its_shape}},
          {"sph_corrected", {holds_its_shape}}};
}

}  // namespace

Case vnv::the_case() {
  const Flow flow = flow_named("elliptic_drop");
  const auto exact = flow.oracle<reference::EllipticDrop>();
  Case declared{
      .title = flow.title(),
      .description =
          flow.judged.description + " At the end it is twice as long as at the start. The Mach number is 1/60.",
      .times = flow.judged.times,
      .monitor = flow.judged.monitor,
      .measurements = {error_of_axes(exact), velocity_errors(flow.velocity()), error_of_pressure(exact)},
      .methods = with_ladder(levels, methods_on(scene_of<Tait>(flow)), claims()),
      .plots = {over_time("length", "Major half-axis over time", "From the second moments of the particles.",
                          {"half-axis [m]"}, 0, {"40 across"}),
                exact_over_time("length", [=](double t) { return exact.at(t).a; }, end),
                error_against_spacing("order", "Error against particle spacing",
                                      fmt::format("L2 error of the velocity, over particles, at t = {:g} s.", end),
                                      "L2 v [%]", l2_velocity, end)}};
  return with_work(std::move(declared), {.error = l2_velocity,
                                         .times = {end},
                                         .length = 2 * R,
                                         .cells = {10, 20, 30, 40, 60, 80},
                                         .particles = {20, 30, 40, 60, 80, 120},
                                         .kernels = {1.2, 1.5, 2}});
}
