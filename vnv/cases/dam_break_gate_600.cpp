/// The dam break of Lobovský et al. (2014) at a filling of 0.6 m, with its gate: the column that Sun et al. compute.

#include "vnv/flows/gated_dam.hpp"
#include "vnv/methods/free_surface_methods.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::gated_dam;

namespace {

constexpr double end = 2, output_interval = 1e-3;  // s

/// The particles across H of MPM, and those of SPH, whose runs take ten times as long.
const std::vector<Level> mpm_levels =
    levels_across(filled_600.height, {{20, end, end, end}, {40, 0, end, end}, {80, 0, 0, end}});
const std::vector<Level> sph_levels = levels_across(filled_600.height, {{20, end, end, end}, {40, 0, 0, end}});

std::map<std::string, std::vector<Claim>> claims() {
  const std::vector<Claim> front{
      between(front_speed_error, -5, 5, baseline("the front of the experiment is that of one filling, known to 5 %"))
          .on("80 across")};
  return {{"mpm_apic", front}, {"mpm_xpic", front}};
}

/// Without corrected gradients: there a few particles end so dense, and alone, that the energy of their compression is
/// 6 % of the fall.
std::vector<Method> all_methods() {
  const Scene<Tait, Uniform> scene = collapse(filled_600);
  std::vector<Method> all =
      with_ladder(mpm_levels, {mpm_apic(scene, output_interval), mpm_xpic(scene, output_interval)}, claims());
  for (const Method& method :
       with_ladder(sph_levels, {sph_delta(scene, output_interval), sph_shifted(scene, output_interval)}, claims()))
    all.push_back(method);
  for (Method& method : all)
    method.tolerance = {method.family == Family::mpm ? 0.1 : 0.5,
                        "a sensor sees a few particles, whose pressures another rounding changes after the impact",
                        0.005};
  return all;
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Dam break with its gate, 0.6 m high",
      .description =
          "A column of water 0.6 m square stands behind a gate, in a tank 1.61 m long, with the gate of the experiment of "
          "Lobovský et al. (2014), which is drawn up at 4.53 m/s: `dam_break` is the same column without it. The front "
          "is compared with that measured, T from 0.2 to 1.5, and the water has to live through the impact, to 2 s.",
      .times = {end},
      .watch = monitored,
      .measurements = {[](const Level& level, const Run& run) { return compared(filled_600, level, run); }},
      .claims = {at_most(energy_made, 0.01, theory("gravity is the only source of energy"))},
      .methods = all_methods()};
}
