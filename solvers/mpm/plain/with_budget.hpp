#pragma once
#include "solvers/forces/uniform.hpp"
#include "solvers/mpm/plain/plain.hpp"
#include "solvers/stepping/energy_budget.hpp"

#include <memory>

namespace touchstone::mpm {

/// `Plain`, bit by bit, of water under gravity, that keeps an energy budget.
template <class Shape, class Transfer, class Density>
class WithBudget : public Plain<Shape, Transfer, Density, Tait, Uniform> {
  using Base = Plain<Shape, Transfer, Density, Tait, Uniform>;
  using Base::nodes_, Base::particles_, Base::scene_;

 public:
  std::shared_ptr<EnergyBudget> budget = std::make_shared<EnergyBudget>();

  WithBudget(const Scene<Tait, Uniform>& scene, const Settings& settings) : Base(scene, settings) {
    budget->start = budget->now = energy();
  }

  void step(const Laps& = no_laps) {
    const Energy before = energy();
    this->scatter();
    budget->transfer += kinetic_of(nodes_.start) - before.kinetic;
    this->accelerate();
    record_forces();
    const double accelerated = kinetic_of(nodes_.velocity);
    this->move();
    const Energy moved = energy();
    budget->transfer += moved.kinetic - accelerated;
    budget->gravity += moved.potential - before.potential;
    this->remap();
    const Scalars carried = particles_.expansion;
    this->strain();
    record_strain(carried);
    const Energy strained = energy();
    this->tick();
    this->settle();
    budget->now = energy();
    budget->walls += budget->now.total() - strained.total();
  }

 private:
  Energy energy() const {
    const Vec2& g = scene_.body_force.per_mass;
    return {.kinetic = particles_.mass / 2 * particles_.v.squaredNorm(),
            .potential = -particles_.mass * (g.transpose() * particles_.x).sum(),
            .elastic = elastic_of(particles_.expansion)};
  }
  double elastic_of(const Scalars& expansion) const {
    const auto of_one = [&](double e) { return elastic_energy(scene_.fluid, scene_.fluid.density / (1 + e)); };
    return particles_.mass * expansion.unaryExpr(of_one).sum();
  }
  double kinetic_of(const Vectors& velocity) const {
    return particles_.mass / 2 * (nodes_.mass.transpose() * velocity.colwise().squaredNorm().array()).sum();
  }

  /// Forces go the way of the mean velocity, those of walls too. Gravity is the same on all nodes, the rest of the
  /// forces is stress.
  void record_forces() {
    const Vec2& g = scene_.body_force.per_mass;
    const double dt = this->time_step();
    double by_gravity = 0, by_stress = 0, by_walls = 0;
    for (int node = 0; node < nodes_.count(); ++node) {
      if (!nodes_.moves(node)) continue;
      const Vec2 start = nodes_.start.col(node), end = nodes_.velocity.col(node), mean = (start + end) / 2,
                 force = nodes_.force.col(node), weight = nodes_.mass[node] * g;
      by_gravity += dt * weight.dot(mean);
      by_stress += dt * (force - weight).dot(mean);
      by_walls += (nodes_.mass[node] * (end - start) - dt * force).dot(mean);
    }
    budget->gravity += particles_.mass * by_gravity;
    budget->pressure += particles_.mass * by_stress;
    budget->walls += particles_.mass * by_walls;
  }

  /// Compression by the velocities of the nodes (19), from the expansion that particles carried; then what the nodes
  /// make of it.
  void record_strain(const Scalars& carried) {
    Scalars compressed = carried;
    for (Index p = 0; p < particles_.count(); ++p)
      compressed[p] += (1 + carried[p]) * (this->time_step() * particles_.slopes[p].trace());
    const double strained = elastic_of(compressed);
    budget->pressure += strained - elastic_of(carried);
    budget->smoothing += elastic_of(particles_.expansion) - strained;
  }
};

}  // namespace touchstone::mpm
