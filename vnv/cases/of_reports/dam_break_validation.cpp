/// The dam break of Lobovský et al. (2014) at a filling of 0.3 m, judged by ASME V&V 20-2009.

#include "vnv/flows/dams/gated_dam_ensemble.hpp"
#include "vnv/flows/dams/gated_dam_validation.hpp"
#include "vnv/methods/free_surface_methods.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::gated_dam;

Case vnv::the_case() {
  const auto apic = [](const auto& scene) { return mpm_apic(scene, sampled_every); };
  return {
      .title = "Dam break with its gate: validation",
      .description =
          "The dam break of Lobovský et al. (2014), column 0.6 m long and 0.3 m high, with the gate of the experiment. "
          "Front, levels and the impact on the far wall are compared with the measurements by the procedure of ASME "
          "V&V 20-2009: the comparison error E = S - D is set against the validation uncertainty u_val, which combines "
          "the numerical uncertainty (resolution, bulk modulus, number of starts) with those of the inputs (gate, "
          "height, density, gravity, clocks, positions of sensors) and of the data (repeats). The verdict on each "
          "observable is agreement within 2 u_val, a model error of E ± 2 u_val, or that the uncertainty is too large "
          "to judge.",
      .times = {with_300.end},
      .monitor = monitored,
      .measurements = {},
      .findings = {validation_values(with_300), ensemble_values},
      .claims = {at_least(planted_noticed, 6, baseline("each moves the level in the reservoir by more than 2 u_val")),
                 at_most(model_errors, 8, baseline("6 when first measured: levels at H1 to H3, impulse at P3"))},
      .methods = {validated(with_300, {apic, apic}),
                  validated(with_300, {[](const auto& scene) { return sph_delta(scene, sampled_every); }},
                            {.of_across = {{20, 4}, {40, 4}, {80, 1}}, .varied = 1, .across_varied = 40})},
      .plots = {validation_tables(with_300), ensemble_beside_repeats()}};
}
