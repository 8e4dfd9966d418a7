/// A flow in a periodic square that was chosen so that every term of the equations takes part.

#include "vnv/flows/manufactured.hpp"

#include "reference/manufactured.hpp"
#include "vnv/flows/squares/in_square.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::flows {
namespace {

/// The body force of the manufactured flow, line by line: u and w are components of M / R and `_x` is a slope along x.
std::vector<std::string> formula_of(const Newtonian& fluid) {
  std::vector<std::string> lines{fmt::format("K = {:.17g}", fluid.bulk_modulus),
                                 fmt::format("mu = {:.17g}", fluid.viscosity),
                                 "k = 2*pi/L",
                                 "sx = sin(k*x)",
                                 "cx = cos(k*x)",
                                 "sy = sin(k*y)",
                                 "cy = cos(k*y)",
                                 "a = 1 + sin(omega*t)/2",
                                 "a_t = omega/2*cos(omega*t)",
                                 "R = 1 + ripple*cx*cy",
                                 "R_x = -ripple*k*sx*cy",
                                 "R_y = -ripple*k*cx*sy",
                                 "R_xx = -ripple*k*k*cx*cy",
                                 "R_xy = ripple*k*k*sx*sy",
                                 "u = U*(0.3 - cx*sy)/R",
                                 "u_x = (U*k*sx*sy - u*R_x)/R",
                                 "u_y = (-U*k*cx*cy - u*R_y)/R",
                                 "u_xx = (U*k*k*cx*sy - 2*u_x*R_x - u*R_xx)/R",
                                 "u_xy = (U*k*k*sx*cy - u_x*R_y - u_y*R_x - u*R_xy)/R",
                                 "u_yy = (U*k*k*cx*sy - 2*u_y*R_y - u*R_xx)/R",
                                 "w = U*(0.2 + sx*cy)/R",
                                 "w_x = (U*k*cx*cy - w*R_x)/R",
                                 "w_y = (-U*k*sx*sy - w*R_y)/R",
                                 "w_xx = (-U*k*k*sx*cy - 2*w_x*R_x - w*R_xx)/R",
                                 "w_xy = (-U*k*k*cx*sy - w_x*R_y - w_y*R_x - w*R_xy)/R",
                                 "w_yy = (-U*k*k*sx*cy - 2*w_y*R_y - w*R_xx)/R"};
  for (const auto& [i, x, slope] : {std::tuple("u", "x", "u_xx + w_xy"), std::tuple("w", "y", "u_xy + w_yy")})
    lines.push_back(fmt::format(
        "b_{1} = a_t*{0} + a*a*(u*{0}_x + w*{0}_y) + 7*K/rho*R*R*R*R*R*R_{1} "
        "- mu/(rho*R)*a*({0}_xx + {0}_yy + ({2})/3)",
        i, x, slope));
  return lines;
}

}  // namespace

Flow manufactured(Settings& set) {
  const double L = set.positive("L", square::side, "m", "side of the periodic square");
  const double U = set.positive("U", 1, "m/s", "velocity of the vortices at t = 0");
  const double omega = set("omega", 5, "1/s", "angular frequency of the velocity");
  const double ripple = set("ripple", 0.02, "-", "amplitude of the density, relative; 0 to below 1");
  const double rho = set.positive("rho", 1000, "kg/m³", "density at zero pressure");
  const double c = set.positive("c", 10, "m/s", "speed of sound at zero pressure");
  const double Re = set.positive("Re", 100, "-", "Reynolds number U L / nu");
  const Newtonian fluid = fluid_of(rho, c, U * L / Re);
  const reference::Manufactured exact{L, U, omega, rho, ripple, fluid.bulk_modulus, fluid.viscosity};
  const PressureWith pressure = [exact](const Changes& by) -> PressureTruth {
    return [exact, stiffer = std::pow(by.factor(Cause::sound_speed), 2)](const Vec2& x, double) {
      return stiffer * exact.pressure(x.x(), x.y());
    };
  };
  const VelocityTruth velocity = [exact](const Vec2& x, double t) -> Vec2 {
    return Vec2(exact.velocity(x.x(), x.y(), t).data());
  };
  Flow flow = in_square(L, fluid, [velocity](const Changes&) { return velocity; }, pressure({}), {});
  flow.drive.at = [exact](const Vec2& x, double t) { return Vec2(exact.force(x.x(), x.y(), t).data()); };
  flow.drive.formula = formula_of(flow.fluid);
  for (const auto& [x, y, t] : {std::tuple(0.1, 0.3, 0.0), std::tuple(0.75, 0.2, 0.1), std::tuple(0.5, 0.95, 0.2)}) {
    const auto b = exact.force(x * L, y * L, t);
    flow.drive.examples.push_back({x * L, y * L, t, b[0], b[1]});
  }
  add_pressure(flow, pressure, {Cause::sound_speed});
  flow.judged.title = "Manufactured solution";
  flow.judged.description =
      "A prescribed unsteady compressible flow in a periodic square, and the body force that sustains it exactly: "
      "every term of the equations takes part; the viscous stress has no bulk viscosity.";
  flow.judged.times = {vnv::manufactured::end * L / U};
  return flow;
}

}  // namespace touchstone::vnv::flows
