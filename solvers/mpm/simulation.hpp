#pragma once
/// What all material point methods share: a scene, its grid, and the answers that a run gives; and the step of those
/// that sum over the particles of each cell.

#include "solvers/mpm/beginning.hpp"
#include "solvers/mpm/body_force.hpp"
#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/sorting.hpp"
#include "solvers/samples.hpp"
#include "solvers/stepping/clock.hpp"
#include "solvers/stepping/extremes.hpp"
#include "solvers/stepping/laps.hpp"

namespace touchstone::mpm {

/// How the method resolves a scene. The cell and the spacing are adjusted to fit the domain and the filled box, see
/// `Grid` and `lattice`.
struct Settings {
  double cell;       // m  side of a cell of the background grid
  double spacing;    // m  between particles at the start
  double time_step;  // s
  int threads = 1;   // the results are the same bits for any number
};

template <class FluidLaw, class Force>
class Simulation : public Clock {
 public:
  const Scene<FluidLaw, Force>& scene() const { return scene_; }
  Index boundary_particles() const { return 0; }
  Vec2 cell_size() const { return grid_.cell; }  // m  as fitted to the domain

 protected:
  /// Throws std::invalid_argument for settings that are not positive, a cell larger than the domain, or a wall whose
  /// answer depends on how far the fluid is from it: nodes on a wall have no distance.
  Simulation(const Scene<FluidLaw, Force>& scene, const Settings& settings)
      : Clock("mpm", settings.time_step),
        scene_(scene),
        threads_(settings.threads),
        grid_(scene.domain, settings.cell) {
    require_positive("mpm", "threads", threads_);
    for (const Wall& wall : scene.walls)
      if (wall.depends_on_distance())
        throw std::invalid_argument(fmt::format(
            "mpm: wall at {} = {:g} m answers by the distance of the fluid, expected one that can be asked on the wall",
            wall.axis == 0 ? "x" : "y", wall.position));
  }

  Scene<FluidLaw, Force> scene_;
  int threads_;
  Grid grid_;
};

/// The particles at a time [s], in the order in which they were seeded.
template <class Particles, class FluidLaw>
Samples samples_of(const Particles& particles, const Grid& grid, const FluidLaw& fluid, double time) {
  Samples s = Samples::of_equal(time, particles.count, particles.mass);
  particles.order.for_each([&](int cell, int slot) {
    const int p = particles.number[slot];
    s.x.col(p) = grid.place(cell, particles.X[slot], particles.Y[slot]);
    s.v.col(p) = particles.velocity(slot);
    s.density[p] = fluid.density / (1 + static_cast<double>(particles.expansion[slot]));
    s.pressure[p] = fluid.pressure(s.density[p]);
  });
  return s;
}

/// Of the particles; a slot without one is at rest with the density of rest.
template <class Particles, class FluidLaw>
Extremes extremes_of(const Particles& particles, const FluidLaw& fluid) {
  double square = 0, expansion = 0;
  for (int slot = 0; slot < particles.order.slots(); ++slot) {
    square = std::max(square, particles.velocity(slot).squaredNorm());
    expansion = std::min(expansion, static_cast<double>(particles.expansion[slot]));
  }
  return {std::sqrt(square), fluid.density / (1 + expansion)};
}

/// The same of methods that sum over particles, which they keep in the order of the cells. One derives from it as
/// `Method` and offers the parts of its step, and list_near(), called when other blocks hold particles than before.
template <class Method, class Particles, class Nodes, class FluidLaw, class Force>
class SimulationInCells : public Simulation<FluidLaw, Force> {
 public:
  /// One step, explicit Euler, lumped mass; all weights are those of the places at its start. Throws Diverged.
  void step(const Laps& lap = no_laps) {
    method().scatter();  // m_i, (m v)_i, (12), (13)
    lap(SubStep::scatter);
    method().accelerate();  // (10), (11), (14), as walls have it
    lap(SubStep::grid);
    method().remap();  // (16), (17), as walls have it
    lap(SubStep::remap);
    method().gather();  // (15), (18), (19), (32), (33)
    lap(SubStep::gather);
    this->tick();
    settle();
    lap(SubStep::sorting);
  }

  Index particles() const { return particles_.count; }
  /// The particles in the order in which they were seeded.
  Samples samples() const { return samples_of(particles_, this->grid_, this->scene_.fluid, this->time()); }
  Extremes extremes() const { return extremes_of(particles_, this->scene_.fluid); }

 protected:
  /// Throws besides for a spacing larger than the filled box, or a filled box that reaches out of the domain.
  SimulationInCells(const Scene<FluidLaw, Force>& scene, const Settings& settings)
      : Simulation<FluidLaw, Force>(scene, settings),
        particles_(at_rest<Particles>(scene, settings.spacing, this->grid_)),
        nodes_(this->grid_, Particles::width) {
    set_going(particles_, scene.start, this->grid_, scene.fluid, this->time_step());
  }

  /// Where the fluid is strained by the velocities with which the nodes move, there is nothing to remap.
  static void remap() {}
  /// What walls do to a particle beyond what they do to the nodes.
  static void meet_walls(int /*slot*/, int /*cell*/) {}

  /// Calls push(slot, change of velocity [m/s]) with what a body force that differs from place to place gives each
  /// particle in a step (13).
  template <class Push>
  void push_particles(const Push& push) {
    if constexpr (Local<Force>)
      particles_.order.for_each([&](int cell, int slot) {
        const Vec2 x = this->grid_.place(cell, particles_.X[slot], particles_.Y[slot]), v = particles_.velocity(slot);
        push(slot, this->time_step() * force_on_moving(this->scene_.body_force, x, this->time(), v));
      });
  }

  Particles particles_;
  Nodes nodes_;
  std::vector<LaneBits> calm_;  // of each block, within a step

 private:
  Method& method() { return static_cast<Method&>(*this); }

  /// Carries particles that left their cells to those they are in. Throws Diverged.
  void settle() {
    const auto settle_here = [&](int slot, int cell) {
      if (is_calm(particles_, slot)) return cell;
      method().meet_walls(slot, cell);
      return mpm::settle(particles_, slot, cell, this->grid_, this->scene_.fluid, this->steps(), this->time());
    };
    if (keep_order(particles_, calm_, settle_here)) method().list_near();
  }
};

}  // namespace touchstone::mpm
