#pragma once
/// The material point method with quadratic B-splines and affine particle velocities, for weakly compressible fluids:
/// APIC (Jiang et al., ACM Trans. Graph. 34 (2015) 51) with the stress given to the nodes as in MLS-MPM (Hu et al., ACM
/// Trans. Graph. 37 (2018) 150), explicit Euler.
///
/// Particles take their velocity from the nodes and remember no other: with many particles a wave of wave number k is
/// damped by (k cell)^4 / 40 a step. So the error of a viscous flow grows as the step gets shorter, and at a fixed
/// ratio of step to cell it is of third order. Measured in L2 with 4 particles per cell: Poiseuille flow at 1 s in 10,
/// 20, 40 and 80 cells 23.4, 3.80, 0.52 and 0.068 %, Couette flow at 0.1 s 9.4, 1.39, 0.18 and 0.022 %, with sound
/// crossing 0.8 cells a step; with 0.2 cells a step, in 10, 20 and 40 cells, 55, 13.2, 1.95 % and 25, 5.1, 0.71 %. Use
/// the longest stable step: 0.8 cells last; 1.2 last for thousands of steps from an even lattice, but not always
/// longer.

#include "solvers/mpm/affine/mirrors.hpp"
#include "solvers/mpm/affine/transfer.hpp"
#include "solvers/mpm/printed/node_motion.hpp"
#include "solvers/mpm/simulation.hpp"

namespace touchstone::mpm {

/// One simulation of a scene. `Number` is what particles are stored and reckoned in; nodes are in double. A change of
/// the time step reaches the stress, which particles hold as what it gives in a step, one step later.
template <class Number, class FluidLaw, class Force>
class Affine : public SimulationInCells<AffineParticles<Number>, AffineNodes, FluidLaw, Force> {
  using Base = SimulationInCells<AffineParticles<Number>, AffineNodes, FluidLaw, Force>;
  using Base::calm_, Base::grid_, Base::nodes_, Base::particles_, Base::scene_, Base::threads_;

 public:
  using Base::time;

  /// Throws std::invalid_argument as its base does, and for a wall off the grid.
  Affine(const Scene<FluidLaw, Force>& scene, const Settings& settings)
      : Base(scene, settings), mirrors_(scene.walls, grid_) {
    list_near();
  }

  /// One step. Throws Diverged.
  template <class Laps = NoLaps>
  void step(const Laps& lap = {}) {
    const double dt = this->time_step();
    push_particles();                       // v_p + dt b(x_p), where b is not the same everywhere
    scatter(particles_, threads_, nodes_);  // m_i = sum m_p w_ip, (m v)_i = sum m_p w_ip (v_p + C_p (x_i - x_p)) + ...
    lap(SubStep::scatter);
    nodes_.collect(dt * common_acceleration(scene_.body_force), threads_);  // + dt b m_i
    mirrors_.fold(nodes_, time() + dt);                                     // images behind walls give too
    nodes_.find_velocities(threads_);                                       // v_i = (m v)_i / m_i
    mirrors_.unfold(nodes_, time() + dt);
    lap(SubStep::grid);
    gather(nodes_, grid_, scene_.fluid, dt, threads_, particles_, calm_);  // v_p, C_p, x_p, rho_p, (32), (33)
    this->end_step(lap, [&] { list_near(); });
  }

 private:
  void push_particles() {
    if constexpr (Local<Force>) push(particles_, grid_, scene_.body_force, time(), this->time_step());
  }

  void list_near() {
    nodes_.list_near(particles_.order);
    mirrors_.list_near(nodes_);
  }

  Mirrors mirrors_;
};

/// A simulation of a scene: `mpm::affine(channel, {.cell = ...})`.
template <class Number = double, class FluidLaw, class Force>
auto affine(const Scene<FluidLaw, Force>& scene, const Settings& settings) {
  return Affine<Number, FluidLaw, Force>(scene, settings);
}

}  // namespace touchstone::mpm
