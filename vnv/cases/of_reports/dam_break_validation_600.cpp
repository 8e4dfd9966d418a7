/// The front of the dam break of Lobovský et al. (2014) at a filling of 0.6 m, judged by ASME V&V 20-2009.

#include "vnv/flows/dams/gated_dam_validation.hpp"
#include "vnv/methods/free_surface_methods.hpp"

using namespace touchstone::vnv;
using namespace touchstone::vnv::gated_dam;

Case touchstone::vnv::the_case() {
  const auto apic = [](const auto& scene) { return mpm_apic(scene, sampled_every); };
  return validation_by(
      with_600, "Dam break with its gate, 0.6 m high: validation",
      "The front of the dam break of Lobovský et al. (2014), column 0.6 m square, with the gate of the experiment, "
      "is compared with the measured one by the procedure of ASME V&V 20-2009, as in dam_break_validation for "
      "the column half as high.",
      {validated(with_600, {apic, apic}, {.of_across = {{20, 4}, {40, 4}, {80, 4}, {160, 1}}})},
      {at_most(model_errors, 0, baseline("none when first measured"))});
}
