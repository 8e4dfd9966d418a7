/// A shear wave that decays by viscosity alone in a periodic square.

#include "reference/shear_wave.hpp"
#include "vnv/flows/squares/in_square.hpp"

namespace touchstone::vnv::flows {

Flow shear_wave(Settings& set) {
  const double L = set.positive("L", square::side, "m", "side of the periodic square, and wavelength");
  const double U = set.positive("U", 1, "m/s", "amplitude of the velocity at t = 0");
  const double rho = set.positive("rho", 1000, "kg/m³", "density at rest");
  const double Re = set.positive("Re", 100, "-", "Reynolds number U L / nu");
  const double c = set.positive("c", 10, "m/s", "speed of sound at rest");
  const auto exact = [=](const Changes& by) {
    return reference::ShearWave{.L = L, .U = U, .nu = U * L / Re * by.factor(Cause::viscosity)};
  };
  Flow flow = in_square(
      L, fluid_of(rho, c, exact({}).nu),
      [=](const Changes& by) -> VelocityTruth {
        return [now = exact(by)](const Vec2& x, double t) -> Vec2 { return {now(x.y(), t), 0}; };
      },
      [](const Vec2&, double) { return 0.0; }, {Cause::viscosity});
  flow.exact_solution = exact({});
  flow.judged.title = "Decaying shear wave";
  flow.judged.description =
      "The velocity along x is a sine of y and decays by viscosity alone: an exact solution of the Navier-Stokes "
      "equations.";
  flow.judged.times = {0.1 * L / U, L / U};
  flow.judged.plots = errors_of_velocity("order", "L2 v [%]", l2_velocity, flow.judged.times.front());
  return flow;
}

}  // namespace touchstone::vnv::flows
