/// A shear wave that decays by viscosity alone in a periodic square.

#include "reference/shear_wave.hpp"
#include "vnv/flows/squares/in_square.hpp"

namespace touchstone::vnv::flows {

Flow shear_wave(Settings& set) {
  const DecaysInSquare box(set, ", and wavelength", "amplitude of the velocity at t = 0", 10);
  const auto exact = [=](const Changes& by) { return reference::ShearWave{.L = box.L, .U = box.U, .nu = box.nu(by)}; };
  Flow flow = in_square(
      box.L, box.fluid(),
      [=](const Changes& by) -> VelocityTruth {
        return [now = exact(by)](const Vec2& x, double t) -> Vec2 { return {now(x.y(), t), 0}; };
      },
      [](const Vec2&, double) { return 0.0; }, {Cause::viscosity});
  flow.exact_solution = exact({});
  flow.judged.title = "Decaying shear wave";
  flow.judged.description =
      "The velocity along x is a sine of y and decays by viscosity alone: an exact solution of the Navier-Stokes "
      "equations.";
  flow.judged.times = {0.1 * box.L / box.U, box.L / box.U};
  flow.judged.plots = errors_of_velocity("order", "L2 v [%]", l2_velocity, flow.judged.times.front());
  return flow;
}

}  // namespace touchstone::vnv::flows
