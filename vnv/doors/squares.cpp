/// Flows in a square: periodic along both axes, or in a box with a lid.

#include "reference/shear_wave.hpp"
#include "reference/taylor_green.hpp"
#include "vnv/doors/flows.hpp"
#include "vnv/flows/lid_driven.hpp"
#include "vnv/flows/manufactured.hpp"
#include "vnv/flows/shear_wave.hpp"
#include "vnv/flows/taylor_green.hpp"
#include "vnv/judge/norms.hpp"
#include "vnv/measures/steadiness.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::doors {
namespace {

/// The fields where something is wrong.
using VelocityWith = std::function<VelocityTruth(const Changes&)>;
using PressureWith = std::function<PressureTruth(const Changes&)>;

Flow in_square(double side, const Newtonian& fluid, const VelocityWith& velocity_with, PressureTruth pressure,
               std::vector<Cause> causes) {
  const VelocityTruth velocity = velocity_with({});
  Flow flow;
  flow.filled = {.high = {side, side}};
  flow.domain = {.box = flow.filled, .periodic_x = true, .periodic_y = true};
  flow.fluid = fluid;
  flow.across = side;
  flow.start = {.velocity = [velocity](const Vec2& x) { return velocity(x, 0); },
                .pressure = [pressure](const Vec2& x) { return pressure(x, 0); }};
  flow.judged.claims = {is_consistent(l2_velocity)};
  flow.measured = {{{"velocity"}, velocity_errors(velocity)}};
  flow.exact = {{.field = "velocity",
                 .norms = {l2_velocity.name, linf_velocity.name},
                 .components = 2,
                 .causes = std::move(causes),
                 .with = velocity_with}};
  return flow;
}

void add_pressure(Flow& flow, const PressureWith& with, std::vector<Cause> causes) {
  flow.measured.push_back({{"pressure"}, pressure_errors(with({}))});
  flow.measured.push_back({{"pressure"}, part_of_exact_pressure(with({}), true)});
  flow.aside.push_back(has_its_pressure());
  flow.exact.push_back({.field = "pressure",
                        .norms = {l2_pressure.name},
                        .less_mean = true,
                        .causes = std::move(causes),
                        .with = [with](const Changes& by) -> FieldTruth {
                          return [truth = with(by)](const Vec2& x, double t) { return Vec2(truth(x, t), 0); };
                        }});
}

Newtonian fluid_of(double rho, double c, double nu) {
  return {{.density = rho, .bulk_modulus = rho * c * c / Tait::gamma}, rho * nu};
}

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
        "b_{1} = a_t*{0} + a*a*(u*{0}_x + w*{0}_y) + 7*K/rho*R*R*R*R*R*R_{1} - mu/(rho*R)*a*({0}_xx + {0}_yy + ({2})/3)",
        i, x, slope));
  return lines;
}

}  // namespace

Flow taylor_green(Settings& set) {
  const double L = set.positive("L", square::side, "m", "side of the periodic square");
  const double U = set.positive("U", vnv::taylor_green::U, "m/s", "largest velocity at t = 0");
  const double rho = set.positive("rho", vnv::taylor_green::rho, "kg/m³", "density at rest");
  const double Re = set.positive("Re", 100, "-", "Reynolds number U L / nu");
  const double c = set.positive("c", 80, "m/s", "speed of sound at rest");
  const auto exact = [=](const Changes& by) {
    return reference::TaylorGreen{.L = L, .U = U, .nu = U * L / Re * by.factor(Cause::viscosity), .rho = rho};
  };
  const PressureWith pressure = [=](const Changes& by) -> PressureTruth {
    return [now = exact(by)](const Vec2& x, double t) { return now.p(x.x(), x.y(), t); };
  };
  Flow flow = in_square(L, fluid_of(rho, c, exact({}).nu),
                        [=](const Changes& by) -> VelocityTruth {
                          return [now = exact(by)](const Vec2& x, double t) -> Vec2 {
                            return {now.v_x(x.x(), x.y(), t), now.v_y(x.x(), x.y(), t)};
                          };
                        },
                        pressure({}), {Cause::viscosity});
  add_pressure(flow, pressure, {Cause::viscosity});
  flow.judged.title = "Taylor-Green vortices";
  flow.judged.description =
      "Four vortices in a periodic square decay. The oracle is Taylor's (1923) solution for an incompressible fluid.";
  flow.judged.times = {vnv::taylor_green::early * L / U, vnv::taylor_green::end * L / U};
  flow.judged.plots = errors_of_velocity("order", "L2 v [%]", l2_velocity, flow.judged.times.front());
  return flow;
}

Flow manufactured(Settings& set) {
  using vnv::manufactured::Chosen;
  Chosen chosen;
  chosen.L = set.positive("L", chosen.L, "m", "side of the periodic square");
  chosen.U = set.positive("U", chosen.U, "m/s", "velocity of the vortices at t = 0");
  chosen.omega = set("omega", chosen.omega, "1/s", "angular frequency of the velocity");
  chosen.ripple = set("ripple", chosen.ripple, "-", "amplitude of the density, relative; 0 to below 1");
  chosen.rho0 = set.positive("rho", chosen.rho0, "kg/m³", "density at zero pressure");
  chosen.c = set.positive("c", chosen.c, "m/s", "speed of sound at zero pressure");
  chosen.Re = set.positive("Re", chosen.Re, "-", "Reynolds number U L / nu");
  const reference::Manufactured exact = chosen.exact();
  const PressureWith pressure = [exact](const Changes& by) -> PressureTruth {
    return [right = vnv::manufactured::pressure_of(exact), stiffer = std::pow(by.factor(Cause::sound_speed), 2)](
               const Vec2& x, double t) { return stiffer * right(x, t); };
  };
  Flow flow = in_square(chosen.L, chosen.fluid(),
                        [exact](const Changes&) { return vnv::manufactured::velocity_of(exact); }, pressure({}), {});
  flow.drive.formula = formula_of(flow.fluid);
  for (const auto& [x, y, t] : {std::tuple(0.1, 0.3, 0.0), std::tuple(0.75, 0.2, 0.1), std::tuple(0.5, 0.95, 0.2)}) {
    const auto b = exact.force(x * chosen.L, y * chosen.L, t);
    flow.drive.examples.push_back({x * chosen.L, y * chosen.L, t, b[0], b[1]});
  }
  add_pressure(flow, pressure, {Cause::sound_speed});
  flow.judged.title = "Manufactured solution";
  flow.judged.description =
      "A prescribed unsteady compressible flow in a periodic square, and the body force that sustains it exactly: "
      "every term of the equations takes part; the viscous stress has no bulk viscosity.";
  flow.judged.times = {vnv::manufactured::end * chosen.L / chosen.U};
  return flow;
}

Flow shear_wave(Settings& set) {
  const double L = set.positive("L", square::side, "m", "side of the periodic square, and wavelength");
  const double U = set.positive("U", vnv::shear_wave::U, "m/s", "amplitude of the velocity at t = 0");
  const double rho = set.positive("rho", vnv::shear_wave::rho, "kg/m³", "density at rest");
  const double Re = set.positive("Re", vnv::shear_wave::Re, "-", "Reynolds number U L / nu");
  const double c = set.positive("c", vnv::shear_wave::c, "m/s", "speed of sound at rest");
  const double nu = U * L / Re;
  Flow flow = in_square(
      L, fluid_of(rho, c, nu),
      [=](const Changes& by) -> VelocityTruth {
        return [now = reference::ShearWave{.L = L, .U = U, .nu = nu * by.factor(Cause::viscosity)}](const Vec2& x,
                                                                                                    double t) -> Vec2 {
          return {now(x.y(), t), 0};
        };
      },
      [](const Vec2&, double) { return 0.0; }, {Cause::viscosity});
  flow.judged.title = "Decaying shear wave";
  flow.judged.description =
      "The velocity along x is a sine of y and decays by viscosity alone: an exact solution of the Navier-Stokes equations.";
  flow.judged.times = {0.1 * L / U, L / U};
  flow.judged.plots = errors_of_velocity("order", "L2 v [%]", l2_velocity, flow.judged.times.front());
  return flow;
}

Flow cavity(Settings& set) {
  using namespace lid_driven;
  const double side = set.positive("L", lid_driven::cavity.side, "m", "side of the box");
  const double lid = set.positive("V", lid_driven::cavity.lid_speed, "m/s", "velocity of the lid from t = 0 on");
  const Cavity box{.side = side, .lid_speed = lid, .span = steady_for * side / lid};
  const double density = set.positive("rho", rho, "kg/m³", "density at rest");
  const double sound_speed = set.positive("c", c, "m/s", "speed of sound at rest");
  const double Re = set.positive("Re", flows[0].Re, "-", "Reynolds number V L / nu: 100, 400 or 1000");
  const auto* const known = std::ranges::find(flows, Re, &lid_driven::Flow::Re);
  if (known == flows.end()) throw std::invalid_argument(fmt::format("Re = {:g}, expected 100, 400 or 1000", Re));
  const double end = known->end * side / lid, last = box.span;  // s
  doors::Flow flow;
  set_scene(flow, scene_with(box, density, sound_speed, Re, {lid, 0}));
  flow.across = side;
  flow.judged.title = "Lid-driven cavity";
  flow.judged.description =
      "The lid of a square box slides from t = 0, at full speed over its whole length. When the flow is steady, "
      "velocities on both centrelines, averaged over the last 5 L / V, are compared with the tables of Ghia, Ghia & "
      "Shin (1982), whose own errors are up to 1 % of the lid's speed.";
  for (const int before : {5, 4, 3, 2, 1, 0}) flow.judged.times.push_back(end - before * last / 5);
  flow.judged.monitor = kinetic_energy_every(output_interval * side / lid);
  flow.judged.plots = {lid_driven::work()};
  flow.of_resolved = within(2, ghia);
  flow.resolved = 100;
  flow.of_coarse = [](double across) {  // as fine as 2 % at 100 across, with room for first order with twice that error
    return within(
        std::max(2.0, 150 / across),
        literature("Ghia, Ghia & Shin 1982, tables I and II; our own methods are up to 5.4 % off at 24 across"));
  };
  const Quantity fastest{"largest speed over that of the lid"};
  flow.aside = {at_most(fastest, 2, theory("nothing drives a fluid faster than the lid; twice that is no overshoot"))};
  flow.measured = {{{"velocity"},
                    [=](const Level& level, const Run& run) -> std::vector<Value> {
                      double largest = 0;
                      for (const Samples& s : run.samples)
                        largest = norms::larger_magnitude(largest, s.v.colwise().norm().maxCoeff());
                      return {{level.name, level.spacing, run.samples.back().time, fastest, largest / lid}};
                    },
                    Span{INFINITY, 0, 1},
                    "the speed"},
                   {{"velocity"},
                    [=](const Level& level, const Run& run) { return against_ghia(level, run, box, known->Re); },
                    Span{INFINITY, end, 1},
                    "the steady flow"},
                   {{"velocity"},
                    [=](const Level&, const Run& run) { return unsteadiness_of(run, 0, last); },
                    Span{end - last, end, 2, true},
                    "how steady the flow is"}};
  return flow;
}

}  // namespace touchstone::vnv::doors
