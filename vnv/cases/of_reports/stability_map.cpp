/// Where each method is stable and where it is accurate: over the acoustic and the viscous Courant number, and over
/// stiffness and Reynolds number with the step that it chooses.

#include "vnv/record/record.hpp"
#include "vnv/stability/stability_map.hpp"

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

/// A map as a level of a method and as a figure.
struct Drawn {
  std::string level, id;
  MakeMap make;
  std::string title, caption;
  Axis x, y;

  std::string figure_of(const std::string& method) const { return id + "_" + method; }
};

/// Those of a method; least squares want four particles in a cell or more, the regularised methods h = 1 spacing.
std::vector<Drawn> maps_for(const LatticeMethod& method) {
  const std::string length = method.has_grid() ? "cell" : "spacing";
  const Axis acoustic{.label = "c dt / " + length, .logarithmic = true};
  std::vector<Drawn> maps{
      {"Courant numbers",
       "numbers",
       map_of_courant_numbers,
       "stability over acoustic and viscous Courant number",
       "A shear wave of a hundredth of the speed of sound decays on a periodic lattice. Each point is a simulation of "
       "400 to 1500 steps, until the amplitude has halved.",
       acoustic,
       {.label = "nu dt / " + length + "^2", .logarithmic = true}},
      {"arrangements",
       "arrangements",
       map_of_arrangements,
       "stability over resolution of the kernel or cell",
       "A shear wave of a ten-thousandth of the speed of sound, over the smoothing length or the number of particles "
       "in a cell, with nu dt = 0.01 " +
           length + "^2.",
       acoustic,
       {.label = method.has_grid() ? "particles in a cell" : "h / spacing", .low = 0}},
      {"fluids",
       "fluids",
       map_of_fluids,
       "stability over stiffness and Reynolds number",
       "A decaying shear wave with the step that the method chooses, over the wave's Reynolds number and the bulk "
       "modulus, relative to that at which the Mach number is 0.1.",
       {.label = "Reynolds number", .logarithmic = true},
       {.label = "K / K at Mach 0.1", .logarithmic = true}}};
  if (method.fits || method.one_kernel) maps.erase(maps.begin() + 1);
  return maps;
}

Method maps_of(const LatticeMethod& on_lattice) {
  Method method = on_lattice.on({}, {});
  method.claims = {
      at_least(stable_as_theory, 95, theory("except on the boundary, simulation and linear theory agree")),
      at_least(stable_where_made_for, 100, theory("the time step that a method chooses is stable")).on("fluids")};
  std::vector<NamedRun> runs;
  for (const Drawn& map : maps_for(on_lattice))
    runs.push_back({on_lattice.usual_lattice().level(map.level),
                    [=, make = map.make, figure = map.figure_of(method.name)](const Level&, const Schedule&) {
                      return make(on_lattice, figure);
                    }});
  return with_runs(std::move(method), std::move(runs));
}

void declare_figures(const Results& results, Record& record) {
  const std::string& name = results.method.name;
  for (const Drawn& map : maps_for(method_on_lattice(name)))
    record.figures.push_back({map.figure_of(name), name + ": " + map.title, map.caption, map.x, map.y});
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Stability maps",
      .description =
          "A shear wave on a doubly periodic lattice, 16 particles across. Maps over the acoustic and the viscous "
          "Courant number, and over the number of particles in a cell or the smoothing length, also show the stability "
          "boundary of linear theory, from the largest eigenvalue of the method's own linearised step. Over eight "
          "decades each of stiffness and Reynolds number, each method uses the time step that it chooses.",
      .times = {1},
      .measurements = {},
      .methods = each_of(methods_on_lattice(), maps_of),
      .plots = {declare_figures},
      .label = "stability",
  };
}
