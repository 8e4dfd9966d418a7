#pragma once
#include "solvers/mpm/composed/plain_transfer.hpp"

namespace touchstone::mpm {

/// PIC whose smoothing is taken back to the order m (XPIC(m), Hammerquist & Nairn, Comput. Methods Appl. Mech. Eng. 318
/// (2017), 724-738): with S from nodes to particles and S⁺ from particles to nodes, velocities become
/// (I - (I - S S⁺)^m) v_p + S dv_i. XPIC(1) is PIC (Harlow 1964); for large m only what no node sees is damped. Linear
/// momentum is conserved. Places move with the nodes, as in the other transfers.
template <int m>
struct Xpic : GivesItsVelocity {
  static_assert(m >= 1);

  template <class Shape>
  static void gather(const Weights<Shape>& weights, const PlainNodes& nodes, int threads, PlainParticles& particles) {
    Vectors smoothed = nodes.velocity - nodes.change;  // (S⁺ S)^(k - 1) v_i, in the term k
    Vectors velocity = nodes.velocity + (m - 1) * smoothed, on_particles(2, particles.count());
    double binomial = m;  // m over k, with the sign of the term
    for (int k = 2; k <= m; ++k) {
      for_particles(particles, threads, [&](Index p) { on_particles.col(p) = weights.at(p, smoothed); });
      scatter_velocity(
          weights, nodes, threads, [&](Index p, const Vec2&) -> Vec2 { return on_particles.col(p); }, smoothed);
      binomial *= -static_cast<double>(m - k + 1) / k;
      velocity += binomial * smoothed;
    }
    for_particles(particles, threads, [&](Index p) { particles.v.col(p) = weights.at(p, velocity); });
  }
};

}  // namespace touchstone::mpm
