/// The observed order in time of each method: velocities after the same time, at a fixed spacing and ever shorter steps.

#include "vnv/judge/order.hpp"
#include "vnv/record/record.hpp"
#include "vnv/stability/critical_step.hpp"
#include "vnv/stability/lattice_starts.hpp"
#include "vnv/stability/methods_on_lattice.hpp"

#include <cmath>
#include <string>
#include <utility>

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

const Quantity order_in_time{"order in time of the velocity", "", Kind::value},
    half_width_of_it{"half-width of the order in time", "", Kind::value, Better::smaller},
    finest_difference{"L2 difference of the velocity, the two shortest steps", "%", Kind::norm},
    change_per_step{"L2 change of the velocity by each further step", "%", Kind::norm};

constexpr double c = RestingLattice::sound_speed;

/// A shear wave and a sound wave in a viscous fluid: every part of a step takes part.
Start waves(const RestingLattice& lattice) {
  return {.velocity = [side = lattice.side()](const Vec2& x) -> Vec2 {
    return {0.05 * c * wave_at(x.y(), side), 0.01 * c * wave_at(x.y(), side)};
  }};
}

/// Velocities [m/s] after half of the time in which sound crosses the lattice, in so many steps.
Vectors after(const LatticeMethod& method, const RestingLattice& lattice, long steps) {
  const double dt = lattice.side() / c / 2 / static_cast<double>(steps);
  Simulation simulation = simulate(method.on, lattice, waves(lattice), dt * c / lattice.unit());
  for (long k = 0; k < steps; ++k) simulation.step();
  return simulation.samples().v;
}

/// Methods that are seen beside each other: no more than a figure has colours.
std::pair<std::string, std::string> figure_of(const std::string& method) {
  if (method.starts_with("mpm")) return {"steps_mpm", "MPM"};
  if (method == "sph_delta" || method == "sph_corrected" || method == "sph_shifted")
    return {"steps_free_surface", "SPH for free surfaces"};
  return {"steps_sph", "SPH"};
}

Run in_ever_shorter_steps(const LatticeMethod& method, const RestingLattice& lattice) {
  constexpr int halvings = 4;
  const CostMeter meter;
  const double chosen = method.on(lattice, {}).time_step(lattice.level());
  long steps = std::lround(std::ceil(lattice.side() / c / 2 / chosen)), all = steps;
  std::vector<double> step, difference;
  Vectors before = after(method, lattice, steps);
  for (int k = 0; k < halvings; ++k, steps *= 2) {
    const Vectors now = after(method, lattice, 2 * steps);
    step.push_back(1 / static_cast<double>(steps));
    difference.push_back(100 * (now - before).norm() / now.norm());
    all += 2 * steps, before = now;
  }
  const ObservedOrder found = observe_order(step, difference);
  Run run = run_of_trials(meter, lattice.particles(), 0, all);
  run.add(order_in_time, found.order);
  run.add(half_width_of_it, found.half_width);
  run.add(finest_difference, difference.back());
  run.add(change_per_step, difference.back() / static_cast<double>(steps / 2));
  run.curves = {{figure_of(method.name()).first, method.name(), Role::ours, step, difference, false}};
  return run;
}

/// What is claimed of the methods, by the integrators that they have.
std::vector<Claim> claims_of(const std::string& method) {
  const auto of_first_order = [](const std::string& why) {
    return std::vector{between(order_in_time, 0.8, 1.2, theory(why))};
  };
  if (method == "mpm") return of_first_order("velocities and places in turn, stresses once a step: order 1");
  if (method == "sph_regularised" || method == "sph_transport_velocity" || method == "sph_delta" ||
      method == "sph_corrected" || method == "sph_shifted")
    return of_first_order("kick-drift-kick with forces that depend on the velocity: order 1");
  if (method == "sph_one_evaluation") return {at_least(order_in_time, 1.8, theory("Adams-Bashforth: order 2"))};
  if (method == "mpm_least_squares") return {at_least(order_in_time, 1.8, theory("steps of second order"))};
  return {};  // that each step takes from the velocity what it does, however short: by its baselines
}

Method of(const LatticeMethod& on_lattice) {
  RestingLattice lattice = on_lattice.usual_lattice();
  if (on_lattice.has_grid()) lattice.cells *= 3;  // as printed and with affine velocities a step smooths over a cell
  lattice.reynolds = 10;
  Method method = on_lattice.on({}, {});
  method.tolerance = {0.02, "what is left of differences of velocities"};
  method.claims = claims_of(method.name);
  return with_runs(std::move(method), {{lattice.level("waves", true), [=](const Level&, const Schedule&) {
                                          return in_ever_shorter_steps(on_lattice, lattice);
                                        }}});
}

void draw(const Results& results, Record& record) {
  const auto [id, title] = figure_of(results.method.name);
  record.figures.push_back({id,
                            "Differences of the velocity by halving the time step: " + title,
                            "L2 difference of the velocities of all particles after the same time, in so many steps "
                            "and in twice as many. First order has the slope 1; where each step smooths, it is -1.",
                            {.label = "1 / steps", .logarithmic = true},
                            {.label = "L2 v [%]", .logarithmic = true}});
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Order in time",
      .description =
          "A shear wave and a sound wave in a viscous fluid on a doubly periodic lattice, half the time in which sound "
          "crosses it, in the step that a method chooses and in 2, 4, 8 and 16 times as many. The spacing is fixed, so "
          "that only the integrator's error changes: the order is that of differences between successive steps. "
          "Transfers that smooth in each step, however short (APIC and its kin, and printed SPH, whose densities are "
          "restored every 30 steps), have none: of them it is told by how much each further step changes the velocity.",
      .times = {1},
      .measurements = {},
      .methods = each_of(methods_on_lattice(), of),
      .plots = {draw,
                limits_table("Order in time", "Of differences of the velocity between successive halvings.", "flow",
                             {{"order", order_in_time},
                              {"half-width", half_width_of_it},
                              {"finest difference [%]", finest_difference},
                              {"change by each further step [%]", change_per_step}})},
  };
}
