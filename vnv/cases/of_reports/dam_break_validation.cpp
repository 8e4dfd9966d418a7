/// The dam break of Lobovský et al. (2014) at a filling of 0.3 m, judged by ASME V&V 20-2009.

#include "vnv/flows/dams/gated_dam_ensemble.hpp"
#include "vnv/flows/dams/gated_dam_validation.hpp"
#include "vnv/methods/free_surface_methods.hpp"

using namespace touchstone::vnv;
using namespace touchstone::vnv::gated_dam;

Case touchstone::vnv::the_case() {
  const auto apic = [](const auto& scene) { return mpm_apic(scene, sampled_every); };
  const auto delta = [](const auto& scene) { return sph_delta(scene, sampled_every); };
  Case declared = validation_by(
      with_300, "Dam break with its gate: validation",
      "The dam break of Lobovský et al. (2014), column 0.6 m long and 0.3 m high, with the gate of the experiment. "
      "Front, levels and the impact on the far wall are compared with the measurements by the procedure of ASME "
      "V&V 20-2009: the comparison error E = S - D is set against the validation uncertainty u_val, which combines "
      "the numerical uncertainty (resolution, bulk modulus, number of starts) with those of the inputs (gate, "
      "height, density, gravity, clocks, positions of sensors) and of the data (repeats). The verdict on each "
      "observable is agreement within 2 u_val, a model error of E ± 2 u_val, or that the uncertainty is too large "
      "to judge.",
      {validated(with_300, {apic, apic}),
       validated(with_300, {delta}, {.of_across = {{20, 4}, {40, 4}, {80, 1}}, .varied = 1, .across_varied = 40})},
      {at_least(planted_noticed, 6, baseline("each moves the level in the reservoir by more than 2 u_val")),
       at_most(model_errors, 8, baseline("6 when first measured: levels at H1 to H3, impulse at P3"))});
  declared.findings.push_back(ensemble_values);
  return with_plots(std::move(declared), {ensemble_beside_repeats()});
}
