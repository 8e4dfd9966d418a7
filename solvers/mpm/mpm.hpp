#pragma once
/// The material point method as printed by Sun et al., section 2.1: explicit Euler, lumped mass, the stress updated
/// last with the momentum remapped from the particles (MUSL, Sulsky, Zhou & Schreyer 1995), particle velocities updated
/// by increments (FLIP). All weights of a step are those of the places at its start.

#include "solvers/forces/uniform.hpp"
#include "solvers/mpm/seed.hpp"
#include "solvers/mpm/settle.hpp"
#include "solvers/mpm/shapes/linear_hat.hpp"
#include "solvers/mpm/transfer.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"
#include "solvers/mpm/walls/prescribed_velocity.hpp"
#include "solvers/mpm/walls/velocity_reset.hpp"
#include "solvers/mpm/walls/wall_nodes.hpp"
#include "solvers/samples.hpp"

#include <concepts>

namespace touchstone::mpm {

/// How the method resolves a scene. The cell and the spacing are adjusted to fit the domain and the filled box, see
/// `Grid` and `lattice`.
struct Settings {
  double cell;       // m  side of a cell of the background grid
  double spacing;    // m  between particles at the start
  double time_step;  // s
};

/// One simulation of a scene. `Shape` interpolates between nodes and particles, `WallTreatment` says how a wall's
/// answer reaches the particles. A fluid without viscosity carries a pressure only; `NoForce` leaves the force out.
template <class Shape, class WallTreatment, class FluidLaw, class Force>
class Mpm {
 public:
  /// Throws std::invalid_argument for settings that are not positive, a cell larger than the domain, a spacing larger
  /// than the filled box, a filled box that reaches out of the domain, or a wall off the grid.
  Mpm(const Scene<FluidLaw, Force>& scene, const Settings& settings)
      : scene_(scene),
        dt_(settings.time_step),
        grid_(scene.domain, settings.cell),
        particles_(at_rest(lattice(scene.filled, settings.spacing, scene.domain.box), grid_, scene.fluid)),
        nodes_(grid_.nodes()),
        masses_(grid_.cells()),
        wall_nodes_(scene.walls, grid_) {
    require_positive("mpm", "time step [s]", dt_);
    suspects_.reserve(grid_.cells());
    nodes_.list_near(grid_, particles_.order.occupied());
  }

  /// One MUSL step. Throws Diverged.
  void step() {
    nodes_.clear();
    scatter<Shape>(particles_, grid_, masses_, nodes_);                      // m_i, (m v)_i, (12)
    scatter_force();                                                         // (13)
    accelerate_nodes();                                                      // (10), (14)
    wall_nodes_.template hold<WallTreatment>(nodes_, grid_, time(), dt_);    // (14) at walls
    add_changes<Shape>(particles_.order, grid_, masses_, nodes_);            // (16) as (17) sees it
    remap_velocity();                                                        // (17)
    wall_nodes_.hold_remapped(nodes_, time() + dt_);                         // (17) at walls
    gather<Shape>(nodes_, grid_, scene_.fluid, dt_, particles_, suspects_);  // (15), (16), (18), (19)
    ++steps_;
    keep_order();
  }

  double time() const { return static_cast<double>(steps_) * dt_; }  // s
  long steps() const { return steps_; }
  double time_step() const { return dt_; }  // s
  Eigen::Index particles() const { return particles_.count; }
  Eigen::Index boundary_particles() const { return 0; }
  Vec2 cell_size() const { return grid_.cell; }  // m  as fitted to the domain

  /// The particles in the order in which they were seeded.
  Samples samples() const {
    const Eigen::Index n = particles();
    Samples s{time(), Vectors(2, n), Vectors(2, n), Scalars::Constant(n, particles_.mass), Scalars(n), Scalars(n)};
    for (int cell : particles_.order.occupied())
      for (int slot = particles_.order.begin(cell); slot < particles_.order.end(cell); ++slot) {
        const int p = particles_.number[slot];
        s.x.col(p) = grid_.place(cell, particles_.X[slot], particles_.Y[slot]);
        s.v.col(p) = Vec2(particles_.vx[slot], particles_.vy[slot]);
        s.density[p] = 1 / particles_.specific_volume[slot];
        s.pressure[p] = scene_.fluid.pressure(s.density[p]);
      }
    return s;
  }

 private:
  /// The same force everywhere is added to the nodes' accelerations, which the weights leave as it is.
  static constexpr bool force_is_uniform = std::same_as<Force, Uniform>;

  void scatter_force() {
    if constexpr (is_present<Force> && !force_is_uniform)
      scatter_body_force<Shape>(particles_, grid_, scene_.body_force, time(), nodes_);
  }

  void accelerate_nodes() {
    const Vec2 cells_per_velocity = dt_ * grid_.cell.cwiseInverse();
    for (int node : nodes_.near) {
      const NodeSums& sums = nodes_.sums[node];
      NodeMotion& motion = nodes_.motion[node];
      motion = {};
      if (!nodes_.moves(node)) continue;
      Vec2 a = sums.force / sums.mass;
      if constexpr (force_is_uniform) a += scene_.body_force.per_mass;
      motion.change = dt_ * a;
      motion.displacement = (sums.velocity() + motion.change).cwiseProduct(cells_per_velocity);
    }
  }

  void remap_velocity() {
    for (int node : nodes_.near)
      if (nodes_.moves(node)) nodes_.motion[node].remapped = nodes_.sums[node].velocity();
  }

  /// Carries the particles that left their cell to the one they are in; looks only where `gather` saw cause to.
  void keep_order() {
    CellOrder& order = particles_.order;
    for (int cell : suspects_)
      for (int slot = order.begin(cell); slot < order.end(cell);) {
        const int to = settle(particles_, slot, cell, grid_, scene_.fluid, steps_, time());
        if (to != cell) order.carry(particles_, slot, cell, to);
        if (to <= cell) ++slot;  // carried upwards, it left its slot to another of its cell
      }
    if (!order.is_stale()) return;
    order.list_occupied();
    nodes_.list_near(grid_, order.occupied());
  }

  Scene<FluidLaw, Force> scene_;
  double dt_;
  Grid grid_;
  Particles<FluidLaw> particles_;
  Nodes nodes_;
  std::vector<CellMass<double>> masses_;  // of each cell, within a step
  WallNodes wall_nodes_;
  std::vector<int> suspects_;  // cells
  long steps_ = 0;
};

/// A simulation of a scene: `mpm::solver<mpm::LinearHat, mpm::PrescribedMotion>(channel, {.cell = ...})`.
template <class Shape, class WallTreatment, class FluidLaw, class Force>
auto solver(const Scene<FluidLaw, Force>& scene, const Settings& settings) {
  return Mpm<Shape, WallTreatment, FluidLaw, Force>(scene, settings);
}

}  // namespace touchstone::mpm
