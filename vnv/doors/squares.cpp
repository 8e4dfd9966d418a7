/// Flows in a square that is periodic along both axes.

#include "reference/shear_wave.hpp"
#include "reference/taylor_green.hpp"
#include "vnv/doors/flows.hpp"
#include "vnv/flows/shear_wave.hpp"
#include "vnv/flows/taylor_green.hpp"

namespace touchstone::vnv::doors {
namespace {

Flow in_square(double side, const Newtonian& fluid, VelocityTruth velocity, PressureTruth pressure) {
  Flow flow;
  flow.filled = {.high = {side, side}};
  flow.domain = {.box = flow.filled, .periodic_x = true, .periodic_y = true};
  flow.fluid = fluid;
  flow.across = side;
  flow.start = {.velocity = [velocity](const Vec2& x) { return velocity(x, 0); },
                .pressure = [pressure](const Vec2& x) { return pressure(x, 0); }};
  flow.judged.claims = {is_consistent(l2_velocity)};
  flow.measured = {{{"velocity"}, velocity_errors(velocity)}};
  return flow;
}

Newtonian fluid_of(double rho, double c, double nu) {
  return {{.density = rho, .bulk_modulus = rho * c * c / Tait::gamma}, rho * nu};
}

}  // namespace

Flow taylor_green(Settings& set) {
  const double L = set.positive("L", square::side, "m", "side of the periodic square");
  const double U = set.positive("U", vnv::taylor_green::U, "m/s", "largest velocity at t = 0");
  const double rho = set.positive("rho", vnv::taylor_green::rho, "kg/m³", "density at rest");
  const double Re = set.positive("Re", 100, "-", "Reynolds number U L / nu");
  const double c = set.positive("c", 80, "m/s", "speed of sound at rest");
  const reference::TaylorGreen exact{.L = L, .U = U, .nu = U * L / Re, .rho = rho};
  const PressureTruth pressure = [exact](const Vec2& x, double t) { return exact.p(x.x(), x.y(), t); };
  Flow flow = in_square(
      L, fluid_of(rho, c, exact.nu),
      [exact](const Vec2& x, double t) -> Vec2 {
        return {exact.v_x(x.x(), x.y(), t), exact.v_y(x.x(), x.y(), t)};
      },
      pressure);
  flow.measured.push_back({{"pressure"}, pressure_errors(pressure)});
  flow.judged.title = "Taylor-Green vortices";
  flow.judged.description =
      "Four vortices in a periodic square decay. The oracle is Taylor's (1923) solution for an incompressible fluid.";
  flow.judged.times = {vnv::taylor_green::early * L / U, vnv::taylor_green::end * L / U};
  flow.judged.plots = errors_of_velocity("order", "L2 v [%]", l2_velocity, flow.judged.times.front());
  return flow;
}

Flow shear_wave(Settings& set) {
  const double L = set.positive("L", square::side, "m", "side of the periodic square, and wavelength");
  const double U = set.positive("U", vnv::shear_wave::U, "m/s", "amplitude of the velocity at t = 0");
  const double rho = set.positive("rho", vnv::shear_wave::rho, "kg/m³", "density at rest");
  const double Re = set.positive("Re", vnv::shear_wave::Re, "-", "Reynolds number U L / nu");
  const double c = set.positive("c", vnv::shear_wave::c, "m/s", "speed of sound at rest");
  const reference::ShearWave exact{.L = L, .U = U, .nu = U * L / Re};
  Flow flow = in_square(
      L, fluid_of(rho, c, exact.nu),
      [exact](const Vec2& x, double t) -> Vec2 {
        return {exact(x.y(), t), 0};
      },
      [](const Vec2&, double) { return 0.0; });
  flow.judged.title = "Decaying shear wave";
  flow.judged.description =
      "The velocity along x is a sine of y and decays by viscosity alone: an exact solution of the Navier-Stokes equations.";
  flow.judged.times = {0.1 * L / U, L / U};
  flow.judged.plots = errors_of_velocity("order", "L2 v [%]", l2_velocity, flow.judged.times.front());
  return flow;
}

}  // namespace touchstone::vnv::doors
