/// Hydrostatic equilibrium: pressure, and spurious motion.

#include "vnv/flows/water_at_rest.hpp"
#include "vnv/measures/plots/along_ladders.hpp"
#include "vnv/measures/plots/over_time.hpp"
#include "vnv/measures/plots/profiles.hpp"
#include "vnv/studies/run_time.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::water_at_rest;

namespace {

constexpr double end = 10;  // s

const std::vector<Level> levels = levels_across(depth, {{20, 2, 0, end}, {40, 0, 0, end}, {80, 0, 0, end}}),
                         // For methods that take more than a minute with 80 across, without adding information.
    coarser = levels_across(depth, {{20, 2, 0, end}, {28, 0, 0, end}, {40, 0, 0, end}});

Claim is_still() { return at_most(kinetic, 1e-6, baseline("a thousandth of the gravity wave speed counts as rest")); }

/// Of a method that holds water at rest, for 2 s with 20 across and for 10 s with 40.
std::vector<Claim> claims(const Claim& still_for_long = is_still()) {
  std::vector<Claim> all = {is_still().on("20 across").at(2), still_for_long.on("40 across").at(end)};
  for (const auto& [level, time] : {std::pair("20 across", 2.0), std::pair("40 across", end)}) {
    all.push_back(at_most(l2_p, 0.5, baseline("a hydrostatic pressure within 0.5 % is expected")).on(level).at(time));
    all.push_back(at_most(displacement, 0.1, baseline("a thousandth of the depth counts as rest")).on(level).at(time));
  }
  return all;
}

/// At rest to 1e-9 for 5 s; then the particles rearrange once, within a second.
Claim rearranges() { return at_most(kinetic, 2e-5, baseline("1.5 times the first measured value, at 6 s")); }

std::vector<Method> methods_up_levels(const Scene<Tait, Uniform>& scene) {
  std::vector<Method> methods = with_ladder(levels, methods_on(scene),
                                            {{"mpm_affine", claims()},
                                             {"mpm_apic", claims()},
                                             {"mpm_xpic", claims()},
                                             {"sph_delta", claims(rearranges())}});
  for (Method& method : methods)
    if (method.name == "mpm_apic" || method.name == "mpm_xpic" || method.name == "sph")
      method = with_ladder(coarser, method, method.claims);
  return methods;
}

}  // namespace

Case vnv::the_case() {
  const Flow flow = flow_named("hydrostatic");
  const auto& water = flow.oracle<reference::Hydrostatic>();
  Case declared{
      .title = flow.title(),
      .description = flow.judged.description + " Each row of particles starts at the height at which it has its "
                                               "equilibrium column of water above it.",
      .times = flow.judged.times,
      .monitor = flow.judged.monitor,
      .measurements = {norms_of("p, per particle", pressures, pressure_of(water)), spurious_motion(depth)},
      .methods = methods_up_levels(scene_of<Tait, Uniform>(flow)),
      .plots = {
          profiles({"profile",
                    "Pressure profile",
                    "All particles of the runs with 40 particles over the depth.",
                    {"y [m]"},
                    {"p [kPa]", 1e-3}},
                   pressures, pressure_of(water), water.h, {"40 across"}),
          over_time("energy", "Kinetic over potential energy", "Potential energy relative to the bottom.",
                    {.label = "kinetic / potential energy", .logarithmic = true}, 0, {"40 across"}),
          error_against_spacing("order", "Error against spacing",
                                "L2 error of the pressure, particle by particle, after 10 s.", "L2 p [%]", l2_p, end)}};
  return with_work(std::move(declared), {.error = l2_p,
                                         .times = {2},
                                         .length = depth,
                                         .cells = {10, 20, 30, 40, 60, 80},
                                         .particles = {10, 20, 30, 40, 60, 80},
                                         .kernels = {1.2, 1.5, 2}});
}
