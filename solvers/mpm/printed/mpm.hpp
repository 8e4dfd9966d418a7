#pragma once
/// The material point method as printed by Sun et al., section 2.1: explicit Euler, lumped mass, the stress updated
/// last with the momentum remapped from the particles (MUSL, Sulsky, Zhou & Schreyer 1995), particle velocities updated
/// by increments (FLIP). All weights of a step are those of the places at its start.

#include "solvers/mpm/printed/node_motion.hpp"
#include "solvers/mpm/printed/transfer.hpp"
#include "solvers/mpm/samples_of.hpp"
#include "solvers/mpm/seed.hpp"
#include "solvers/mpm/settings.hpp"
#include "solvers/mpm/settle.hpp"
#include "solvers/mpm/shapes/linear_hat.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "solvers/mpm/walls/prescribed_velocity.hpp"
#include "solvers/mpm/walls/velocity_reset.hpp"
#include "solvers/mpm/walls/wall_nodes.hpp"
#include "solvers/stepping/clock.hpp"
#include "solvers/stepping/laps.hpp"

namespace touchstone::mpm {

/// One simulation of a scene, with linear shape functions (hats). `WallTreatment` says how a wall's
/// answer reaches the particles, `Number` is what particles are stored and reckoned in; nodes are in double. A fluid
/// without viscosity carries a pressure only; `NoForce` leaves the force out.
template <class WallTreatment, class Number, class FluidLaw, class Force>
class Mpm : public Clock {
 public:
  /// Throws std::invalid_argument for settings that are not positive, a cell larger than the domain, a spacing larger
  /// than the filled box, a filled box that reaches out of the domain, or a wall off the grid.
  Mpm(const Scene<FluidLaw, Force>& scene, const Settings& settings)
      : Clock("mpm", settings.time_step),
        scene_(scene),
        threads_(settings.threads),
        grid_(scene.domain, settings.cell),
        particles_(at_rest<Particles<FluidLaw, Number>>(scene, settings.spacing, grid_)),
        nodes_(grid_, lanes_of<Number>),
        wall_nodes_(scene.walls, scene.start, grid_, nodes_) {
    require_positive("mpm", "threads", threads_);
    set_going(particles_, scene.start, grid_, scene.fluid, time_step());
    list_near();
  }

  /// One MUSL step. Throws Diverged.
  template <class Laps = NoLaps>
  void step(const Laps& lap = {}) {
    const double dt = time_step();
    // m_i, (m v)_i, (12), (13)
    scatter(particles_, grid_, scene_.body_force, time(), threads_, masses_, nodes_);
    lap(SubStep::scatter);
    accelerate(nodes_, scene_.body_force, grid_.cell, dt, threads_);      // (10), (11), (14)
    wall_nodes_.template hold<WallTreatment>(nodes_, grid_, time(), dt);  // (14) at walls
    scatter_changes(particles_, masses_, threads_, nodes_);               // (16) as (17) sees it
    remap_velocity(nodes_, threads_);                                     // (17)
    wall_nodes_.hold_remapped(nodes_, time() + dt);                       // (17) at walls
    lap(SubStep::grid);
    gather(nodes_, grid_, scene_.fluid, dt, threads_, particles_, calm_);  // (15), (16), (18), (19)
    lap(SubStep::gather);
    tick();
    if (keep_order(particles_, calm_, grid_, scene_.fluid, steps(), time())) list_near();
    lap(SubStep::sorting);
  }

  const Scene<FluidLaw, Force>& scene() const { return scene_; }
  Eigen::Index particles() const { return particles_.count; }
  Eigen::Index boundary_particles() const { return 0; }
  Vec2 cell_size() const { return grid_.cell; }  // m  as fitted to the domain

  /// The particles in the order in which they were seeded.
  Samples samples() const { return samples_of(particles_, grid_, scene_.fluid, time()); }
  Extremes extremes() const { return extremes_of(particles_, scene_.fluid); }

 private:
  void list_near() {
    nodes_.list_near(particles_.order);
    wall_nodes_.list_near(nodes_);
  }

  Scene<FluidLaw, Force> scene_;
  int threads_;
  Grid grid_;
  Particles<FluidLaw, Number> particles_;
  Nodes nodes_;
  WallNodes wall_nodes_;
  std::vector<CellMass<Lanes>> masses_;  // of each cell, within a step
  std::vector<char> calm_;               // of each block, within a step
};

/// A simulation of a scene: `mpm::solver<mpm::PrescribedMotion>(channel, {.cell = ...})`.
template <class WallTreatment, class Number = double, class FluidLaw, class Force>
auto solver(const Scene<FluidLaw, Force>& scene, const Settings& settings) {
  return Mpm<WallTreatment, Number, FluidLaw, Force>(scene, settings);
}

}  // namespace touchstone::mpm
