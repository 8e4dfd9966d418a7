/// Decaying Taylor-Green vortices [Taylor 1923] in a periodic square.

#include "vnv/flows/taylor_green.hpp"

#include "vnv/flows/squares/in_square.hpp"

namespace touchstone::vnv::flows {

Flow taylor_green(Settings& set) {
  const DecaysInSquare box(set, "", "largest velocity at t = 0", 80);
  const auto exact = [=](const Changes& by) {
    return reference::TaylorGreen{.L = box.L, .U = box.U, .nu = box.nu(by), .rho = box.rho};
  };
  const PressureWith pressure = [=](const Changes& by) -> PressureTruth {
    return [now = exact(by)](const Vec2& x, double t) { return now.p(x.x(), x.y(), t); };
  };
  Flow flow = in_square(box.L, box.fluid(),
                        [=](const Changes& by) -> VelocityTruth {
                          return [now = exact(by)](const Vec2& x, double t) -> Vec2 {
                            return {now.v_x(x.x(), x.y(), t), now.v_y(x.x(), x.y(), t)};
                          };
                        },
                        pressure({}), {Cause::viscosity});
  add_pressure(flow, pressure, {Cause::viscosity});
  flow.exact_solution = exact({});
  flow.judged.title = "Taylor-Green vortices";
  flow.judged.description =
      "Four vortices in a periodic square decay. The oracle is Taylor's (1923) solution for an incompressible fluid.";
  flow.judged.times = {vnv::taylor_green::early * box.L / box.U, vnv::taylor_green::end * box.L / box.U};
  flow.judged.plots = errors_of_velocity("order", "L2 v [%]", l2_velocity, flow.judged.times.front());
  return flow;
}

}  // namespace touchstone::vnv::flows
