#pragma once
/// The material point method with quadratic B-splines and affine particle velocities: APIC (Jiang et al. 2015) with the
/// stress spread as in MLS-MPM (Hu et al. 2018), for weakly compressible fluids.

#include "solvers/forces/uniform.hpp"
#include "solvers/laps.hpp"
#include "solvers/mpm/affine_mirrors.hpp"
#include "solvers/mpm/affine_transfer.hpp"
#include "solvers/mpm/mpm.hpp"
#include "solvers/mpm/settle.hpp"
#include "solvers/samples.hpp"

#include <concepts>

namespace touchstone::mpm {

/// One simulation of a scene.
template <class FluidLaw, class Force>
class Affine {
 public:
  /// Throws std::invalid_argument for settings that are not positive, a cell larger than the domain, a spacing larger
  /// than the filled box, a filled box that reaches out of the domain, or a wall off the grid.
  Affine(const Scene<FluidLaw, Force>& scene, const Settings& settings)
      : scene_(scene),
        dt_(settings.time_step),
        grid_(scene.domain, settings.cell),
        particles_(affine_at_rest(lattice(scene.filled, settings.spacing, scene.domain.box), grid_, scene.fluid)),
        nodes_(grid_, particles_.order),
        mirrors_(scene.walls, grid_) {
    require_positive("mpm", "time step [s]", dt_);
    suspects_.reserve(grid_.cells());
  }

  /// One step. Throws Diverged.
  template <class Laps = NoLaps>
  void step(const Laps& lap = {}) {
    push();                              // v_p + dt b(x_p)
    scatter(particles_, grid_, nodes_);  // m_i, (m v)_i
    lap(SubStep::scatter);
    move_nodes();
    lap(SubStep::grid);
    gather(nodes_, grid_, scene_.fluid, dt_, particles_, suspects_);
    lap(SubStep::gather);
    ++steps_;
    keep_order();
    lap(SubStep::sorting);
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
        s.v.col(p) = Vec2(particles_.x.v[slot], particles_.y.v[slot]);
        s.density[p] = 1 / particles_.specific_volume[slot];
        s.pressure[p] = scene_.fluid.pressure(s.density[p]);
      }
    return s;
  }

 private:
  /// The same force everywhere is given to the nodes, which the weights leave as it is.
  static constexpr bool force_is_uniform = std::same_as<Force, Uniform>;

  void push() {
    if constexpr (is_present<Force> && !force_is_uniform)
      push_particles(particles_, grid_, scene_.body_force, time(), dt_);
  }

  void move_nodes() {
    for (int row = 0; row < nodes_.rows; ++row) {
      nodes_.collect(row);
      if constexpr (force_is_uniform) nodes_.push(row, dt_ * scene_.body_force.per_mass);
    }
    mirrors_.fold(nodes_, time() + dt_);
    for (int row = 0; row < nodes_.rows; ++row) nodes_.find_velocities(row);
    mirrors_.unfold(nodes_, time() + dt_);
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
    nodes_.list_occupied(order);
  }

  Scene<FluidLaw, Force> scene_;
  double dt_;
  Grid grid_;
  AffineParticles particles_;
  CentreNodes nodes_;
  Mirrors mirrors_;
  std::vector<int> suspects_;  // cells
  long steps_ = 0;
};

/// A simulation of a scene: `mpm::affine(channel, {.cell = ...})`.
template <class FluidLaw, class Force>
auto affine(const Scene<FluidLaw, Force>& scene, const Settings& settings) {
  return Affine<FluidLaw, Force>(scene, settings);
}

}  // namespace touchstone::mpm
