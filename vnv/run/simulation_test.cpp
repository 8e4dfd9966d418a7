#include "vnv/run/simulation.hpp"

#include "vnv/stability/methods_on_lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace touchstone::vnv {
namespace {

const RestingLattice lattice{.cells = 10, .points = 2, .reynolds = 25};
constexpr double courant = 0.1;

/// A simulation of vortices a tenth as fast as sound, in steps of a fraction of `courant`.
Simulation vortices(const LatticeMethod& method, double fraction = 1) {
  const Start start{.velocity = [](const Vec2& x) -> Vec2 {
    const Vec2 k = 2 * std::numbers::pi / lattice.side() * x;
    return RestingLattice::sound_speed / 10 *
           Vec2(std::cos(k.x()) * std::sin(k.y()), -std::sin(k.x()) * std::cos(k.y()));
  }};
  return simulate(method.on, lattice, start, fraction * courant);
}

void run(Simulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) simulation.step();
}

TEST(Simulation, OfAnyMethodMayChangeItsStepAndLosesLittle) {
  for (const LatticeMethod& method : methods_on_lattice()) {
    Simulation even = vortices(method), changed = vortices(method), halves = vortices(method, 0.5);
    run(even, 40);
    run(changed, 20);
    changed.change_time_step(halves.time_step());
    run(changed, 40);
    run(halves, 80);
    EXPECT_NEAR(changed.time(), even.time(), 1e-12 * even.time()) << method.name();
    const Vectors expected = halves.samples().v;
    const double between = (even.samples().v - expected).norm();  // much for affine velocities, which each step damps
    EXPECT_LT((changed.samples().v - expected).norm(), std::max(between, 0.005 * expected.norm())) << method.name();
  }
}

TEST(Simulation, OfAnyMethodKnowsItsFastestSignal) {
  for (const LatticeMethod& method : methods_on_lattice()) {
    Simulation simulation = vortices(method);
    run(simulation, 20);
    const Samples all = simulation.samples();
    const Extremes seen{all.v.colwise().norm().maxCoeff(), all.density.maxCoeff()};
    EXPECT_NEAR(simulation.fastest_signal(), signal_speed(lattice.scene().fluid, seen), 1e-9) << method.name();
  }
}

}  // namespace
}  // namespace touchstone::vnv
