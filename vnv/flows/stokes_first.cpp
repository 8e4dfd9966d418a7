/// Stokes' first problem: a plate below a fluid at rest slides from t = 0, and the boundary layer grows into the fluid.

#include "reference/couette.hpp"
#include "reference/stokes.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channels/plates.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::flows {

Flow stokes_first(Settings& set) {
  const Plates plates(set);
  const double V = set("V", 1 * mm, "m/s", "velocity of the plate from t = 0 on");
  Flow flow = plates.flow(
      "Stokes' first problem",
      "A plate below fluid at rest slides from t = 0. The oracle is Stokes' (1851), for fluid without an upper bound: "
      "the boundary layer has to stay below the free-slip ceiling.",
      plates.times({2.5e-3, 0.01}), no_slip({V, 0}), free_slip(),
      [=](const Changes& by) { return reference::StokesFirst{.V = V, .nu = plates.nu(by)}; }, of_one_plate);
  const double H = plates.H(), until = 0.0635 * H * H / plates.nu();  // 2 erfc(H / sqrt(4 nu t)) = 1 %
  flow.exact[0].instead = {
      instead("ceiling felt",
              fmt::format("the flow is right below its ceiling, which the layer of the plate has reached: fluid "
                          "without an upper bound moves otherwise, by more than 1 % of the plate's velocity from "
                          "{:.3g} s on: judge it before, or with a higher ceiling",
                          until),
              of_both(reference::Couette{.H = 2 * H, .V = V, .nu = plates.nu()}, 2 * H))};
  return flow;
}

}  // namespace touchstone::vnv::flows
