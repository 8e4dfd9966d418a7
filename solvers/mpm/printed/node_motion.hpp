#pragma once
/// What happens on the nodes themselves, between scatter and gather.

#include "solvers/mpm/printed/nodes.hpp"

namespace touchstone::mpm {

/// Velocity (10), acceleration (11) with a body force `b` [m/s²] that all nodes feel alike, and how far they move (14).
inline void accelerate(CornerNodes& nodes, const Vec2& b, const Vec2& cell, double dt, int threads) {
  const Vec2 cells_per_velocity = dt * cell.cwiseInverse();
  for_near(nodes.near(), threads, [&](int node) {
    const Lanes m = nodes.sum(mass, node);
    const auto moves = m > fill<Lanes>(CornerNodes::least_mass);
    const Lanes per_mass = moves ? 1 / (moves ? m : fill<Lanes>(1)) : Lanes{};
    store(per_mass, &nodes.per_mass[node]);
    const auto along = [&](Given momentum, Given given_force, double everywhere, double scale, Field<double>& velocity,
                           Field<double>& change, Field<double>& displacement) {
      const Lanes v = per_mass * nodes.sum(momentum, node);
      const Lanes dv = moves ? dt * (per_mass * nodes.sum(given_force, node) + everywhere) : Lanes{};
      store(v, &velocity[node]);
      store(dv, &change[node]);
      store(scale * (v + dv), &displacement[node]);
    };
    along(momentum_x, force_x, b.x(), cells_per_velocity.x(), nodes.velocity.x, nodes.change.x, nodes.displacement.x);
    along(momentum_y, force_y, b.y(), cells_per_velocity.y(), nodes.velocity.y, nodes.change.y, nodes.displacement.y);
  });
}

/// Velocity (17), from (10) and what the particles change by (16).
inline void remap_velocity(CornerNodes& nodes, int threads) {
  for_near(nodes.near(), threads, [&](int node) {
    const Lanes per_mass = load<Lanes>(&nodes.per_mass[node]);
    for (auto [momentum, velocity] :
         {std::pair(momentum_x, &nodes.velocity.x), std::pair(momentum_y, &nodes.velocity.y)})
      store(load<Lanes>(&(*velocity)[node]) + per_mass * nodes.sum(momentum, node), &(*velocity)[node]);
  });
}

}  // namespace touchstone::mpm
