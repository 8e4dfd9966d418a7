/// The observed order in time of each method: velocities after the same time, at a fixed spacing and ever shorter steps.

#include "vnv/judge/norms.hpp"
#include "vnv/judge/order.hpp"
#include "vnv/stability/critical_step.hpp"
#include "vnv/stability/lattice_starts.hpp"
#include "vnv/stability/methods_on_lattice.hpp"

#include <cmath>

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

const Quantity order_in_time{"order in time, of velocities by successive halvings of the step", "", Kind::value},
    order_uncertain{"half-width of the order in time", "", Kind::value, Better::smaller},
    finest_difference{"L2 difference of velocities between the two shortest steps", "%", Kind::norm},
    loss_per_step{"L2 change of velocities per step that is added", "%", Kind::norm};

constexpr double c = RestingLattice::sound_speed;
constexpr int halvings = 5;

/// A shear wave and a sound wave in a viscous fluid: every part of a step takes part.
Start waves(const RestingLattice& lattice) {
  Start start;
  start.velocity = [side = lattice.side()](const Vec2& x) -> Vec2 {
    return {0.05 * c * wave_at(x.y(), side), 0.01 * c * wave_at(x.y(), side)};
  };
  return start;
}

/// Velocities after half of the time in which sound crosses the lattice, in so many steps.
Vectors after(const LatticeMethod& method, const RestingLattice& lattice, long steps) {
  const double dt = lattice.side() / c / 2 / static_cast<double>(steps);
  Simulation simulation = simulate(method.on, lattice, waves(lattice), dt * c / lattice.unit());
  for (long k = 0; k < steps; ++k) simulation.step();
  return simulation.samples().v;
}

Run in_ever_shorter_steps(const LatticeMethod& method, const RestingLattice& lattice) {
  const CostMeter meter;
  const double first = method.on(lattice, {}).time_step(lattice.level());
  long steps = std::lround(std::ceil(lattice.side() / c / 2 / first)), all = 0;
  std::vector<double> step, difference;
  Vectors before = after(method, lattice, steps);
  for (int k = 0; k < halvings; ++k) {
    const Vectors now = after(method, lattice, 2 * steps);
    step.push_back(1 / static_cast<double>(steps));
    difference.push_back(100 * (now - before).norm() / now.norm());
    all += steps, steps *= 2, before = now;
  }
  const ObservedOrder found = observe_order(step, difference);
  Run run = run_of_trials(meter, lattice.particles(), 0, all);
  run.add(order_in_time, found.order);
  run.add(order_uncertain, found.half_width);
  run.add(finest_difference, difference.back());
  run.add(loss_per_step, difference.back() / static_cast<double>(steps / 2));
  for (std::size_t k = 0; k < difference.size(); ++k) std::printf("%g %g\n", step[k], difference[k]);
  return run;
}

Method of(const LatticeMethod& on_lattice) {
  const RestingLattice usual = on_lattice.usual_lattice();
  RestingLattice lattice = usual;
  lattice.reynolds = 10;
  Method method = on_lattice.on({}, {});
  return with_runs(std::move(method), {{lattice.level("lattice", true), [=](const Level&, const Schedule&) {
                                          return in_ever_shorter_steps(on_lattice, lattice);
                                        }}});
}

}  // namespace

Case vnv::the_case() {
  return {.title = "Order in time",
          .description = "A shear wave and a sound wave in a viscous fluid on a doubly periodic lattice.",
          .times = {1},
          .measurements = {},
          .methods = each_of(methods_on_lattice(), of),
          .label = "stability"};
}
