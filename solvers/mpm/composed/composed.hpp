#pragma once
/// The material point method made of parts that are chosen by type: shape, transfer, density. Plain loops over
/// particles and nodes, a reference for variants; `Mpm`, `Affine` and `Splines` are faster at what they do.

#include "solvers/mpm/composed/densities/carried_density.hpp"
#include "solvers/mpm/composed/plain_transfer.hpp"
#include "solvers/mpm/simulation.hpp"
#include "solvers/mpm/walls/contact.hpp"
#include "solvers/mpm/walls/prescribed_motion.hpp"

namespace touchstone::mpm {

/// One simulation of a scene. `Shape` ties particles to nodes, `Transfer` says what velocities they give and take, and
/// `Density` how that follows the flow. Walls prescribe the motion of their nodes. Explicit Euler, lumped mass; all
/// weights of a step are those of the places at its start.
template <class Shape, class Transfer, class Density, class FluidLaw, class Force>
class Composed : public Simulation<FluidLaw, Force> {
  using Base = Simulation<FluidLaw, Force>;

 protected:
  using Base::grid_, Base::scene_, Base::threads_;

 public:
  using Base::steps, Base::time, Base::time_step;

  /// Throws std::invalid_argument as its base does, for a spacing larger than the filled box, fluid outside the domain,
  /// or a wall where the shape has no node of its own.
  Composed(const Scene<FluidLaw, Force>& scene, const Settings& settings)
      : Base(scene, settings),
        lattice_(lattice(scene.filled, settings.spacing, scene.domain.box)),
        weights_(grid_, lattice_.step),
        nodes_(weights_.nodes()),
        contact_(scene.walls, grid_) {
    for (std::size_t wall = 0; wall < scene.walls.size(); ++wall)
      for (int node : weights_.nodes_on(scene.walls[wall]))
        held_.push_back({node, wall, scene.start.velocity_at(weights_.place(node))});
    std::stable_sort(held_.begin(), held_.end(), [](const Held& a, const Held& b) { return a.node < b.node; });
    begin();
  }

  /// One step, in which the stress is found last, by velocities that the particles give to the nodes anew (MUSL;
  /// Sulsky, Zhou & Schreyer 1995): nodes of little mass, at a free surface, strain less. Throws Diverged.
  template <class Laps = NoLaps>
  void step(const Laps& lap = {}) {
    weights_.find(particles_.x, threads_);
    lap(SubStep::sorting);
    scatter_momentum();
    scatter_forces();
    lap(SubStep::scatter);
    accelerate();
    lap(SubStep::grid);
    gather_motion();
    lap(SubStep::gather);
    remap_velocity();
    lap(SubStep::grid);
    strain_and_stress();
    lap(SubStep::gather);
    this->tick();
    settle();
    lap(SubStep::sorting);
  }

  Index particles() const { return particles_.count(); }
  /// The particles in the order in which they were seeded.
  Samples samples() const {
    Samples s{time(),
              particles_.x,
              particles_.v,
              Scalars::Constant(particles_.count(), particles_.mass),
              scene_.fluid.density / (1 + particles_.expansion),
              Scalars(particles_.count())};
    for (Index p = 0; p < s.size(); ++p) s.pressure[p] = pressure_of_expansion(scene_.fluid, particles_.expansion[p]);
    return s;
  }
  Extremes extremes() const {
    return {std::sqrt(particles_.v.colwise().squaredNorm().maxCoeff()),
            scene_.fluid.density / (1 + particles_.expansion.minCoeff())};
  }

 protected:  // for one that measures between its sub-steps
  struct Held {
    int node;
    std::size_t wall;
    Vec2 of_scene;  // m/s  velocity of the fluid there when the run starts
  };

  /// m_i, and (m v)_i / m_i.
  void scatter_momentum() {
    scatter_mass(weights_, threads_, nodes_);
    scatter_velocity(weights_, nodes_, threads_, given_by_particles(), nodes_.start);
  }
  void scatter_forces() {
    mpm::scatter_forces(weights_, particles_, scene_.fluid, scene_.body_force, time(), threads_, nodes_);
  }
  void accelerate() {
    mpm::accelerate(time_step(), nodes_);
    hold_motion();
  }
  void gather_motion() {
    transfer_.gather(weights_, nodes_, threads_, particles_);
    move_places(weights_, nodes_, time_step(), threads_, particles_);
  }
  void remap_velocity() {
    scatter_velocity(weights_, nodes_, threads_, given_by_particles(), nodes_.velocity);
    for (const Held& held : held_)
      if (nodes_.moves(held.node))
        nodes_.velocity.col(held.node) =
            scene_.walls[held.wall].at_wall(nodes_.velocity.col(held.node), time() + time_step());
  }
  void strain_and_stress() {
    find_slopes(weights_, nodes_, threads_, particles_);
    density_.update(weights_, nodes_, time_step(), threads_, particles_);
  }

  auto given_by_particles() const {
    return [this](Index p, const Vec2& arm) -> Vec2 { return transfer_.given(particles_, p, arm); };
  }

  /// Has the motion of each wall node follow its walls, in the order of the scene.
  void hold_motion() {
    for (auto held = held_.begin(); held < held_.end();) {
      const int node = held->node;
      NodeAtWall at_wall{nodes_.start.col(node), nodes_.velocity.col(node), time(), time() + time_step(), steps() == 0,
                         held->of_scene};
      for (; held < held_.end() && held->node == node; ++held)
        PrescribedMotion::hold(scene_.walls[held->wall], at_wall);
      if (!nodes_.moves(node)) continue;
      nodes_.velocity.col(node) = at_wall.after;
      nodes_.change.col(node) = at_wall.after - at_wall.before;
    }
  }

  void begin() {
    particles_.mass = scene_.fluid.density * lattice_.volume();
    particles_.x = places_in(scene_.domain.box, scene_.start, lattice_);
    const Index n = particles_.count();
    particles_.v = Vectors::Zero(2, n);
    particles_.expansion = Scalars::Zero(n);
    particles_.slopes.assign(n, Slopes<double>{});
    Vectors gradients = Vectors::Zero(2, n);  // 1/m  of the expansion
    const auto expansion = [&](const Vec2& x) { return expansion_at(x, scene_.start, scene_.fluid); };
    if (!scene_.start.at_rest())
      for (Index p = 0; p < n; ++p) {
        const Beginning there = beginning_at(particles_.x.col(p), scene_.start, grid_, scene_.fluid);
        particles_.v.col(p) = there.v;
        particles_.expansion[p] = there.expansion;
        particles_.slopes[p] = there.of;
        for (const int axis : {0, 1}) gradients(axis, p) = slope_along(axis, particles_.x.col(p), grid_, expansion);
      }
    transfer_.begin(particles_);
    density_.begin(particles_, gradients, has_room(particles_.mass * static_cast<double>(n), scene_));
  }

  /// Holds particles at walls and takes them back across periodic boundaries. Throws Diverged for one that has left the
  /// domain or has no plausible density.
  void settle() {
    for (Index p = 0; p < particles_.count(); ++p) {
      contact_.meet(particles_.mass, particles_.x.col(p), [&](const Wall& wall) -> double& {
        particles_.x(wall.axis, p) = wall.position;
        return particles_.v(wall.axis, p);
      });
      const Vec2 place = particles_.x.col(p);
      const auto refuse = [&](std::string quantity, double value, double low, double high) {
        if (low <= value && value <= high) return;
        throw Diverged({steps(), time(), p, place, std::move(quantity), value, fmt::format("{:g} to {:g}", low, high)});
      };
      for (const int axis : {0, 1}) {
        const double low = grid_.box.low[axis], high = grid_.box.high[axis], length = high - low;
        const double slack = scene_.domain.periodic(axis) ? length : 0;  // further in a step is no flow
        refuse(axis == 0 ? "x [m]" : "y [m]", place[axis], low - slack, high + slack);
        particles_.x(axis, p) = scene_.domain.wrapped(axis, place[axis]);
      }
      const double at_rest = scene_.fluid.density;
      refuse("density [kg/m³]", at_rest / (1 + particles_.expansion[p]), least_density * at_rest,
             most_density * at_rest);
    }
  }

  Lattice lattice_;
  PlainParticles particles_;
  Weights<Shape> weights_;
  PlainNodes nodes_;
  WallContact contact_;
  std::vector<Held> held_;  // by node, then in the order of the scene
  Transfer transfer_;
  Density density_;
};

/// A simulation of a scene: `mpm::composed<mpm::BSpline<2>, mpm::Apic>(tank, {.cell = ...})`.
template <class Shape, class Transfer, class Density = CarriedDensity, class FluidLaw, class Force>
auto composed(const Scene<FluidLaw, Force>& scene, const Settings& settings) {
  return Composed<Shape, Transfer, Density, FluidLaw, Force>(scene, settings);
}

}  // namespace touchstone::mpm
