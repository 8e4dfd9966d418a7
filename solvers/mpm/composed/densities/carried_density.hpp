#pragma once
#include "solvers/mpm/composed/plain_transfer.hpp"

namespace touchstone::mpm {

/// Each particle carries its own density, changed by the divergence that it sees (19).
struct CarriedDensity {
  static void begin(const PlainParticles&, const Vectors& /*gradients*/, bool /*has_room*/) {}

  template <class Shape>
  static void update(const Weights<Shape>&, const PlainNodes&, double dt, int threads, PlainParticles& particles) {
    for_particles(particles, threads, [&](Index p) {
      double& expansion = particles.expansion[p];
      expansion += (1 + expansion) * (dt * particles.slopes[p].divergence());
    });
  }
};

}  // namespace touchstone::mpm
