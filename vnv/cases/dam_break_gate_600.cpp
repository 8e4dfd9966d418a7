/// The dam break of Lobovský et al. (2014) at a filling of 0.6 m, with its gate: the column that Sun et al. compute.

#include "vnv/flows/dams/dam_methods.hpp"
#include "vnv/flows/dams/gated_dam.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::gated_dam;

namespace {

std::map<std::string, std::vector<Claim>> claims() {
  const Claim speed =
      between(front_speed_error, -5, 5, baseline("the experiment gives the front of a single filling, known to 5 %"));
  const std::vector<Claim> of_sph{speed.on("80 across")},
      of_mpm{speed.on("80 across"), speed.on("160 across"),
             at_most(front_rms, 0.03, baseline("0.026 (APIC) when first measured; two fillings differ by 0.023"))
                 .on("160 across")};
  return {{"mpm_apic", of_mpm}, {"mpm_xpic", of_mpm}, {"sph_delta", of_sph}, {"sph_shifted", of_sph}};
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Dam break with its gate, 0.6 m high",
      .description =
          "A column of water 0.6 m square stands, in a tank 1.61 m long, behind the gate of the experiment of Lobovský "
          "et al. (2014), which is drawn up at 4.53 m/s; dam_break is the same column without the gate. The front is "
          "compared with the measured one for T from 0.2 to 1.5, and the run has to survive the impact, to 2 s.",
      .times = {end_of_impact},
      .monitor = monitored,
      .measurements = {[](const Level& level, const Run& run) { return compared(filled_600, level, run); }},
      .claims = {makes_no_energy()},
      .methods = methods_with_friction(collapse(filled_600), filled_600.height, friction, claims(), end_of_impact)};
}
