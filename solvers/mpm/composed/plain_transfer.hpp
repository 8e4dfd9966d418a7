#pragma once
/// The state of the composed method and what goes from particles to nodes and back, as plain loops.

#include "solvers/forces/none.hpp"
#include "solvers/mpm/composed/weights.hpp"
#include "solvers/mpm/stress.hpp"

namespace touchstone::mpm {

/// All particles, in the order of their numbers.
struct PlainParticles {
  double mass;                         // kg/m  of each
  Vectors x;                           // m
  Vectors v;                           // m/s
  Scalars expansion;                   // -     rho0 / rho - 1
  std::vector<Slopes<double>> slopes;  // 1/s   of the velocity, when last strained

  Index count() const { return x.cols(); }
};

/// The nodes of the grid, within a step.
struct PlainNodes {
  Scalars mass;      // particles
  Vectors force;     // m/s²  per mass of a particle
  Vectors start;     // m/s   velocity that the particles gave
  Vectors velocity;  // m/s   with which the nodes move, or by which the fluid is strained
  Vectors change;    // m/s   of velocity over the step, as particles feel it

  explicit PlainNodes(Index count)
      : mass(Scalars::Zero(count)), force(Vectors::Zero(2, count)), start(force), velocity(force), change(force) {}

  /// A mass below this is the rounding error of a particle on the edge of its cell; such a node is left out.
  static constexpr double least_mass = 1e-12;  // particles
  bool moves(int node) const { return mass[node] > least_mass; }
  Index count() const { return mass.size(); }
};

/// Calls work(p) for every particle.
template <class Work>
void for_particles(const PlainParticles& particles, int threads, const Work& work) {
  one_by_one(threads, particles.count(), work);
}

/// m_i = sum m_p N_i.
template <class Shape>
void scatter_mass(const Weights<Shape>& weights, int threads, PlainNodes& nodes) {
  nodes.mass.setZero();
  weights.scatter(threads, [&](int node, Index, const Tie& tie) { nodes.mass[node] += tie.weight; });
}

/// v_i = sum m_p N_i v_ip / m_i with `given(p, arm)` [m/s] for v_ip; zero where there is no mass.
template <class Shape, class Given>
void scatter_velocity(const Weights<Shape>& weights, const PlainNodes& nodes, int threads, const Given& given,
                      Vectors& velocity) {
  velocity.setZero();
  weights.scatter(threads, [&](int node, Index p, const Tie& tie) {
    if (nodes.moves(node)) velocity.col(node) += tie.weight / nodes.mass[node] * given(p, tie.arm);
  });
}

/// Pressure [Pa] by Tait's law (33) from the expansion rho0 / rho - 1, with all digits of a small one.
inline double pressure_of_expansion(const Tait& fluid, double expansion) {
  return fluid.bulk_modulus * std::expm1(-Tait::gamma * std::log1p(expansion));
}

/// 2 mu eps - (2/3) mu tr(eps) I - P I over the density [m²/s²], as much of it as the fluid has: (32), (33).
template <class FluidLaw>
Mat2 stress_per_density(const FluidLaw& fluid, double expansion, const Slopes<double>& of_v) {
  const double specific_volume = (1 + expansion) / fluid.density;
  Mat2 stress = -specific_volume * pressure_of_expansion(fluid, expansion) * Mat2::Identity();
  if constexpr (Viscous<FluidLaw>) {
    const double mu = fluid.viscosity * specific_volume, shear = mu * (of_v.xy + of_v.yx),
                 isotropic = -2.0 / 3 * mu * of_v.divergence();
    stress += Mat2{{2 * mu * of_v.xx + isotropic, shear}, {shear, 2 * mu * of_v.yy + isotropic}};
  }
  return stress;
}

/// Internal forces (12) and the body force at the particles (13), at a time [s].
template <class Shape, class FluidLaw, class Force>
void scatter_forces(const Weights<Shape>& weights, const PlainParticles& particles, const FluidLaw& fluid,
                    const Force& body_force, double time, int threads, PlainNodes& nodes) {
  nodes.force.setZero();
  std::vector<Mat2> stress(particles.count());
  Vectors of_body = Vectors::Zero(2, particles.count());
  for_particles(particles, threads, [&](Index p) {
    stress[p] = stress_per_density(fluid, particles.expansion[p], particles.slopes[p]);
    if constexpr (is_present<Force>) of_body.col(p) = body_force(particles.x.col(p), time);
  });
  weights.scatter(threads, [&](int node, Index p, const Tie& tie) {
    nodes.force.col(node) += tie.weight * of_body.col(p) - stress[p] * tie.slope;
  });
}

/// Velocity and its change over a step, (11) and (14), before walls are asked.
inline void accelerate(double dt, PlainNodes& nodes) {
  for (int node = 0; node < nodes.count(); ++node)
    nodes.change.col(node) =
        nodes.moves(node) ? Vec2(dt / nodes.mass[node] * nodes.force.col(node)) : Vec2(Vec2::Zero());
  nodes.velocity = nodes.start + nodes.change;
}

/// Places move with the nodes (15).
template <class Shape>
void move_places(const Weights<Shape>& weights, const PlainNodes& nodes, double dt, int threads,
                 PlainParticles& particles) {
  for_particles(particles, threads, [&](Index p) { particles.x.col(p) += dt * weights.at(p, nodes.velocity); });
}

/// Slopes of the velocity at the particles (18).
template <class Shape>
void find_slopes(const Weights<Shape>& weights, const PlainNodes& nodes, int threads, PlainParticles& particles) {
  for_particles(particles, threads, [&](Index p) {
    Mat2 sum = Mat2::Zero();
    weights.for_nodes_near(p,
                           [&](int node, const Tie& tie) { sum += nodes.velocity.col(node) * tie.slope.transpose(); });
    particles.slopes[p] = {.xx = sum(0, 0), .yx = sum(1, 0), .xy = sum(0, 1), .yy = sum(1, 1)};
  });
}

/// The part of transfers in which a particle gives the nodes its own velocity, and needs nothing else to begin with.
struct GivesItsVelocity {
  static void begin(const PlainParticles&) {}
  static Vec2 given(const PlainParticles& particles, Index p, const Vec2& /*arm*/) { return particles.v.col(p); }
};

}  // namespace touchstone::mpm
