/// Stokes' second problem: a plate below a fluid oscillates in its own plane, and the motion decays with height.

#include "reference/stokes.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/oscillating.hpp"
#include "vnv/flows/channels/plates.hpp"

namespace touchstone::vnv::flows {

Flow stokes_second(Settings& set) {
  const Plates plates(set);
  const double V = set("V", 1 * mm, "m/s", "amplitude of the plate's velocity");
  const Oscillation plate(set, 0.02, "of the plate");
  Flow flow = plates.flow(
      "Stokes' second problem",
      "A plate below fluid oscillates in its own plane as cos(2 pi t / period). The oracle is Stokes' (1851) for a "
      "plate that has always oscillated; its velocity at t = 0 is the initial state. The free-slip ceiling is far "
      "above the layer.",
      plate.times(), oscillating({V, 0}, plate.omega()), free_slip(),
      [=](const Changes& by) { return reference::StokesSecond{.V = V, .omega = plate.omega(), .nu = plates.nu(by)}; },
      of_one_plate);
  flow.wall_frequency = plate.omega();
  flow.exact[0].period = plate.period;
  return flow;
}

}  // namespace touchstone::vnv::flows
