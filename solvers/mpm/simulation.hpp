#pragma once
/// What all material point methods share: a scene, its grid, and the answers that a run gives.

#include "solvers/mpm/beginning.hpp"
#include "solvers/mpm/grid.hpp"
#include "solvers/mpm/samples_of.hpp"
#include "solvers/mpm/seed.hpp"
#include "solvers/mpm/settings.hpp"
#include "solvers/mpm/settle.hpp"
#include "solvers/stepping/clock.hpp"
#include "solvers/stepping/laps.hpp"

namespace touchstone::mpm {

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

/// The same of methods that keep their particles in the order of the cells.
template <class Particles, class Nodes, class FluidLaw, class Force>
class SimulationInCells : public Simulation<FluidLaw, Force> {
 public:
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

  /// Ends a step: carries particles that left their cells to those they are in, and calls list_near() if other blocks
  /// hold particles than before; meet_walls(slot, cell) sees them first. Throws Diverged.
  template <class Laps, class ListNear, class MeetWalls>
  void end_step(const Laps& lap, const ListNear& list_near, const MeetWalls& meet_walls) {
    lap(SubStep::gather);
    this->tick();
    const auto settle_here = [&](int slot, int cell) {
      meet_walls(slot, cell);
      return settle(particles_, slot, cell, this->grid_, this->scene_.fluid, this->steps(), this->time());
    };
    if (keep_order(particles_, calm_, settle_here)) list_near();
    lap(SubStep::sorting);
  }
  template <class Laps, class ListNear>
  void end_step(const Laps& lap, const ListNear& list_near) {
    end_step(lap, list_near, [](int /*slot*/, int /*cell*/) {});
  }

  Particles particles_;
  Nodes nodes_;
  std::vector<LaneBits> calm_;  // of each block, within a step
};

}  // namespace touchstone::mpm
