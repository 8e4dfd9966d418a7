#include "vnv/doors/scene.hpp"

#include "solvers/lattice.hpp"
#include "vnv/files/data_folder.hpp"
#include "vnv/harness/describe.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <set>

namespace touchstone::vnv::doors {
namespace {

using Json = nlohmann::ordered_json;

/// What a wall does to the fluid, by what it answers.
bool holds_fluid(const Wall& wall) { return wall.at_wall({1, 2}, 0) == wall.at_wall({-3, 5}, 0); }
std::string condition_of(const Wall& wall) { return holds_fluid(wall) ? "no slip" : "free slip"; }
Vec2 velocity_of(const Wall& wall) { return holds_fluid(wall) ? wall.at_wall({0, 0}, 0) : Vec2(0, 0); }

Json pair(const Vec2& v) { return {v.x(), v.y()}; }

std::string in_words(const Vec2& v) { return fmt::format("({:g}, {:g})", v.x(), v.y()); }

std::set<std::string> fields_of(const Flow& flow) {
  std::set<std::string> fields{"position"};
  for (const Measured& one : flow.measured) fields.insert(one.fields.begin(), one.fields.end());
  fields.erase("particles");
  if (fields.erase(velocity_along_x)) fields.insert("velocity");
  return fields;
}

std::string oscillation(double angular_frequency) {
  return angular_frequency == 0 ? "" : fmt::format(" times cos({:.10g} t)", angular_frequency);
}

}  // namespace

Vectors places_at_start(const Flow& flow, double spacing) {
  return places_in(flow.domain.box, flow.start, lattice(flow.filled, spacing));
}

std::string scene_in_words(const Flow& flow, double spacing) {
  std::string text = fmt::format("{}: {}\n{}\n\n", flow.name, flow.judged.title, flow.judged.description);
  for (const Parameter& p : flow.parameters)
    text += fmt::format("  {} = {:.10g} {}  {}\n", p.name, p.value, p.unit, p.words);
  const auto periodic = [&](int axis) { return flow.domain.periodic(axis) ? "periodic" : "not periodic"; };
  text += fmt::format("\ndomain: {} to {} m, {} along x, {} along y\n", in_words(flow.domain.box.low),
                      in_words(flow.domain.box.high), periodic(0), periodic(1));
  if (std::isinf(flow.fluid.bulk_modulus))
    text += fmt::format("fluid: incompressible, density {:.10g} kg/m³, viscosity {:.10g} Pa s\n", flow.fluid.density,
                        flow.fluid.viscosity);
  else
    text += fmt::format(
        "fluid: p = K ((rho / rho0)^7 - 1), rho0 = {:.10g} kg/m³, K = {:.10g} Pa (a seventh of the bulk modulus rho0 "
        "c²), sound at {:.10g} m/s, viscosity {:.10g} Pa s\n",
        flow.fluid.density, flow.fluid.bulk_modulus, flow.fluid.sound_speed(), flow.fluid.viscosity);
  for (const Wall& wall : flow.walls)
    text += fmt::format("wall: {} = {:g} m, {}, velocity {} m/s{}\n", wall.axis == 0 ? "x" : "y", wall.position,
                        condition_of(wall), in_words(velocity_of(wall)),
                        velocity_of(wall).isZero() ? "" : oscillation(flow.wall_frequency));
  if (flow.has_free_surface()) text += "free surface: p = 0, wherever there is no wall\n";
  if (!flow.drive.amplitude.isZero())
    text += fmt::format("body force: {} m/s²{}\n", in_words(flow.drive.amplitude),
                        oscillation(flow.drive.angular_frequency));
  if (!flow.drive.formula.empty())
    text +=
        fmt::format("body force [m/s²], of x and y in m and t in s:\n  {}\n", fmt::join(flow.drive.formula, "\n  "));
  if (!flow.formulas.empty())
    text += fmt::format("exact, and prescribed on edges that are not periodic, of x and y in m and t in s:\n  {}\n",
                        fmt::join(flow.formulas, "\n  "));
  if (!flow.residual.empty()) text += flow.residual + "\n";
  text += fmt::format(
      "start: {} from {} to {} m, {} particles with a spacing of {:g} m; places, velocities and pressures: --particles FILE\n",
      flow.shape.empty() ? "the box" : flow.shape, in_words(flow.filled.low), in_words(flow.filled.high),
      places_at_start(flow, spacing).cols(), spacing);
  text += fmt::format("output: {} at t = {:.10g} s; more times are judged, too\n", fmt::join(fields_of(flow), ", "),
                      fmt::join(flow.judged.times, ", "));
  if (std::isfinite(flow.judged.monitor.interval))
    text += fmt::format("output over time: from 0 to {:.10g} s every {:.10g} s or more often\n",
                        flow.judged.times.back(), flow.judged.monitor.interval);
  return text;
}

Description describe(const Flow& flow) {
  Case judged = flow.judged;
  judged.claims.insert(judged.claims.end(), flow.of_resolved.begin(), flow.of_resolved.end());
  return vnv::describe(flow.name, judged, data_folder());
}

std::string scene_as_json(const Flow& flow, double spacing) {
  Json json{{"schema", "touchstone scene 1"},
            {"flow", flow.name},
            {"title", flow.judged.title},
            {"description", flow.judged.description},
            {"parameters", Json::object()}};
  for (const Parameter& p : flow.parameters)
    json["parameters"][p.name] = {{"value", p.value}, {"unit", p.unit}, {"words", p.words}};
  json["domain"] = {{"low [m]", pair(flow.domain.box.low)},
                    {"high [m]", pair(flow.domain.box.high)},
                    {"periodic", {flow.domain.periodic_x, flow.domain.periodic_y}}};
  json["fluid"] = {{"law", "p = K ((rho / rho0)^gamma - 1)"},          {"density [kg/m³]", flow.fluid.density},
                   {"bulk modulus K [Pa]", flow.fluid.bulk_modulus},   {"gamma [-]", Tait::gamma},
                   {"speed of sound [m/s]", flow.fluid.sound_speed()}, {"viscosity [Pa s]", flow.fluid.viscosity}};
  json["filled"] = {{"low [m]", pair(flow.filled.low)},
                    {"high [m]", pair(flow.filled.high)},
                    {"shape", flow.shape.empty() ? "box" : flow.shape}};
  json["free surface"] = flow.has_free_surface();
  json["walls"] = Json::array();
  for (const Wall& wall : flow.walls)
    json["walls"].push_back({{"axis", wall.axis == 0 ? "x" : "y"},
                             {"position [m]", wall.position},
                             {"fluid", wall.inward > 0 ? "above" : "below"},
                             {"condition", condition_of(wall)},
                             {"velocity [m/s]", pair(velocity_of(wall))},
                             {"angular frequency [1/s]", velocity_of(wall).isZero() ? 0 : flow.wall_frequency}});
  json["body force"] = {{"amplitude [m/s²]", pair(flow.drive.amplitude)},
                        {"angular frequency [1/s]", flow.drive.angular_frequency}};
  if (!flow.drive.formula.empty()) {
    json["body force"]["formula"] = flow.drive.formula;
    json["body force"]["examples: x [m], y [m], t [s], b_x [m/s²], b_y [m/s²]"] = flow.drive.examples;
  }
  if (!flow.formulas.empty()) json["exact"] = flow.formulas;
  json["spacing [m]"] = spacing;
  json["times [s]"] = flow.judged.times;
  if (std::isfinite(flow.judged.monitor.interval)) json["times from 0 on, every [s]"] = flow.judged.monitor.interval;
  json["fields"] = fields_of(flow);
  return json.dump(2) + "\n";
}

std::string particles_as_csv(const Flow& flow, double spacing) {
  const Vectors places = places_at_start(flow, spacing);
  std::string text = "x [m],y [m],v_x [m/s],v_y [m/s],p [Pa],rho [kg/m³],mass [kg/m]\n";
  for (Eigen::Index p = 0; p < places.cols(); ++p) {
    const Vec2 x = places.col(p), v = flow.start.velocity_at(x);
    const double pressure = flow.start.pressure_at(x);
    text += fmt::format("{},{},{},{},{},{},{}\n", x.x(), x.y(), v.x(), v.y(), pressure, flow.fluid.density_at(pressure),
                        flow.fluid.density * lattice(flow.filled, spacing).volume());
  }
  return text;
}

}  // namespace touchstone::vnv::doors
