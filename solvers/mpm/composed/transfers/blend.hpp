#pragma once
#include "solvers/mpm/composed/plain_transfer.hpp"

#include <ratio>

namespace touchstone::mpm {

/// So much of FLIP and the rest of PIC, in each step: `Blend<std::ratio<99, 100>>` (Zhu & Bridson 2005).
template <class ShareOfFlip>
struct Blend : GivesItsVelocity {
  static constexpr double flip = static_cast<double>(ShareOfFlip::num) / ShareOfFlip::den, pic = 1 - flip;
  static_assert(0 <= flip && flip <= 1);

  template <class Shape>
  static void gather(const Weights<Shape>& weights, const PlainNodes& nodes, int threads, PlainParticles& particles) {
    for_particles(particles, threads, [&](Index p) {
      const Vec2 kept = particles.v.col(p) + weights.at(p, nodes.change), taken = weights.at(p, nodes.velocity);
      particles.v.col(p) = flip * kept + pic * taken;
    });
  }
};

}  // namespace touchstone::mpm
