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
#include "solvers/mpm/simulation.hpp"

namespace touchstone::mpm {

/// One simulation of a scene. `Number` is what particles are stored and reckoned in; nodes are in double. A change of
/// the time step reaches the stress, which particles hold as what it gives in a step, one step later.
template <class Number, class FluidLaw, class Force>
class Affine
    : public SimulationInCells<Affine<Number, FluidLaw, Force>, AffineParticles<Number>, AffineNodes, FluidLaw, Force> {
  using Base = SimulationInCells<Affine, AffineParticles<Number>, AffineNodes, FluidLaw, Force>;
  using Base::calm_, Base::grid_, Base::nodes_, Base::particles_, Base::scene_, Base::threads_;

 public:
  using Base::time, Base::time_step;

  /// Throws std::invalid_argument as its base does, and for a wall off the grid.
  Affine(const Scene<FluidLaw, Force>& scene, const Settings& settings)
      : Base(scene, settings), mirrors_(scene.walls, grid_) {
    list_near();
  }

 private:
  friend Base;

  /// m_i = sum m_p w_ip, (m v)_i = sum m_p w_ip (v_p + C_p (x_i - x_p)) + what the stress and the body force give in a
  /// step.
  void scatter() {
    this->push_particles([&](int slot, const Vec2& dv) {
      particles_.x.v[slot] += static_cast<Number>(dv.x());
      particles_.y.v[slot] += static_cast<Number>(dv.y());
    });
    mpm::scatter(particles_, threads_, nodes_);
  }
  void accelerate() {
    nodes_.collect(time_step() * common_acceleration(scene_.body_force), threads_);
    mirrors_.fold(nodes_, time() + time_step());  // images behind walls give too
    nodes_.find_velocities(threads_);             // v_i = (m v)_i / m_i
    mirrors_.unfold(nodes_, time() + time_step());
  }
  /// v_p, C_p, x_p, rho_p, (32), (33)
  void gather() { mpm::gather(nodes_, grid_, scene_.fluid, time_step(), threads_, particles_, calm_); }

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
