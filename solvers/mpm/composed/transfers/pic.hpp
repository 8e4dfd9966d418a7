#pragma once
#include "solvers/mpm/composed/plain_transfer.hpp"

namespace touchstone::mpm {

/// Particles take the velocity of the nodes (PIC, Harlow 1964). Linear momentum is conserved; velocities are smoothed
/// over a cell in every step, and angular momentum is lost.
struct Pic : GivesItsVelocity {
  template <class Shape>
  static void gather(const Weights<Shape>& weights, const PlainNodes& nodes, int threads, PlainParticles& particles) {
    for_particles(particles, threads, [&](Index p) { particles.v.col(p) = weights.at(p, nodes.velocity); });
  }
};

}  // namespace touchstone::mpm
