#pragma once
#include "solvers/mpm/composed/plain_transfer.hpp"

namespace touchstone::mpm {

/// Particles keep their velocities and take from the nodes by how much these change (FLIP, Brackbill & Ruppel 1986).
/// Linear momentum is conserved; what no node sees is never damped.
struct Flip : GivesItsVelocity {
  template <class Shape>
  static void gather(const Weights<Shape>& weights, const PlainNodes& nodes, int threads, PlainParticles& particles) {
    for_particles(particles, threads, [&](Index p) { particles.v.col(p) += weights.at(p, nodes.change); });
  }
};

}  // namespace touchstone::mpm
