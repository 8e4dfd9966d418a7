#pragma once
/// The material point method as printed by Sun et al., section 2.1: explicit Euler, lumped mass, the stress updated
/// last with the momentum remapped from the particles (MUSL, Sulsky, Zhou & Schreyer 1995), particle velocities updated
/// by increments (FLIP). All weights of a step are those of the places at its start.

#include "solvers/mpm/printed/nodes.hpp"
#include "solvers/mpm/printed/transfer.hpp"
#include "solvers/mpm/simulation.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "solvers/mpm/walls/prescribed_velocity.hpp"
#include "solvers/mpm/walls/velocity_reset.hpp"
#include "solvers/mpm/walls/wall_nodes.hpp"

namespace touchstone::mpm {

/// One simulation of a scene, with linear shape functions (hats). Particles are stored and
/// computed in `Number`, nodes in double. A fluid without viscosity carries a pressure only; `NoForce` leaves the force
/// out.
template <class Number, class FluidLaw, class Force>
class Mpm : public SimulationInCells<Mpm<Number, FluidLaw, Force>, PrintedParticles<FluidLaw, Number>, CornerNodes,
                                     FluidLaw, Force> {
  using Base = SimulationInCells<Mpm, PrintedParticles<FluidLaw, Number>, CornerNodes, FluidLaw, Force>;
  using Base::calm_, Base::grid_, Base::nodes_, Base::particles_, Base::scene_, Base::threads_;

 public:
  using Base::time, Base::time_step;

  /// `treatment` says how a wall's answer reaches the particles. Throws std::invalid_argument as its base does, and for
  /// a wall off the grid.
  Mpm(const Scene<FluidLaw, Force>& scene, const Settings& settings, WallTreatment treatment)
      : Base(scene, settings), wall_nodes_(scene.walls, scene.start, grid_, nodes_, treatment) {
    list_near();
  }

 private:
  friend Base;

  /// m_i, (m v)_i, (12), (13)
  void scatter() { mpm::scatter(particles_, grid_, local(scene_.body_force), time(), threads_, masses_, nodes_); }
  void accelerate() {
    mpm::accelerate(nodes_, common_acceleration(scene_.body_force), grid_.cell, time_step(), threads_);  // (10) - (14)
    wall_nodes_.hold(nodes_, grid_, time(), time_step());  // (14) at walls
    nodes_.show_first_column(nodes_.change);
    nodes_.show_first_column(nodes_.displacement);
  }
  void remap() {
    scatter_changes(particles_, masses_, threads_, nodes_);   // (16) as (17) sees it
    remap_velocity(nodes_, threads_);                         // (17)
    wall_nodes_.hold_remapped(nodes_, time() + time_step());  // (17) at walls
    nodes_.show_first_column(nodes_.velocity);
  }
  /// (15), (16), (18), (19)
  void gather() { mpm::gather(nodes_, grid_, scene_.fluid, time_step(), threads_, particles_, calm_); }

  void list_near() {
    nodes_.list_near(particles_.order);
    wall_nodes_.list_near(nodes_);
  }

  WallNodes wall_nodes_;
  std::vector<CellMass<Lanes>> masses_;  // of each cell, within a step
};

/// A simulation of a scene: `mpm::printed<mpm::PrescribedMotion>(channel, {.cell = ...})`.
template <class Treatment, class Number = double, class FluidLaw, class Force>
auto printed(const Scene<FluidLaw, Force>& scene, const Settings& settings) {
  return Mpm<Number, FluidLaw, Force>(scene, settings, &Treatment::hold);
}

}  // namespace touchstone::mpm
