#pragma once
/// The material point method made of parts that are chosen by type: what `plain` does, equal but for rounding, over
/// particles in the order of their cells, as many side by side as a vector register holds.

#include "solvers/mpm/lanes/grid_mirrors.hpp"
#include "solvers/mpm/lanes/grid_to_particles_of_mls.hpp"
#include "solvers/mpm/simulation.hpp"
#include "solvers/mpm/walls/contact.hpp"

namespace touchstone::mpm {

/// One simulation of a scene. `Shape`, `Transfer` and `Density` are those of `plain`, or `QuadraticBSpline` and
/// `MlsApic`; walls prescribe the motion of their nodes, or mirror. The stress comes last (MUSL).
template <class Shape, class Transfer, class Density, class FluidLaw, class Force>
class InLanes : public SimulationInCells<InLanes<Shape, Transfer, Density, FluidLaw, Force>,
                                         LaneParticles<FluidLaw, Transfer, Density>, LaneNodes<ShapeInLanes<Shape>>,
                                         FluidLaw, Force> {
  using Base = SimulationInCells<InLanes, LaneParticles<FluidLaw, Transfer, Density>, LaneNodes<ShapeInLanes<Shape>>,
                                 FluidLaw, Force>;
  using Base::calm_, Base::grid_, Base::nodes_, Base::particles_, Base::scene_, Base::threads_;

 public:
  using Base::time, Base::time_step;

  /// Throws std::invalid_argument as its base does, and for a wall where the shape has no node of its own.
  InLanes(const Scene<FluidLaw, Force>& scene, const Settings& settings)
      : Base(scene, settings),
        shape_(grid_, lattice(scene.filled, settings.spacing, scene.domain.box).step),
        walls_(scene.walls, scene.start, grid_, shape_, nodes_),
        contact_(scene.walls, grid_),
        transfer_(nodes_) {
    nodes_.make_room(Moved::given);
    if constexpr (Moved::remaps) nodes_.strained = NodeVectors(nodes_.places());
    begin_gradients();
    list_near();
  }

  /// What contact with walls has taken from the fluid so far.
  const Contacts& contacts() const { return contact_.sum; }

 private:
  friend Base;
  static_assert(std::same_as<Transfer, MlsApic> == std::same_as<Shape, QuadraticBSpline>,
                "MlsApic needs splines whose spread is the same everywhere, and walls that mirror serve it alone");
  using Moved = TransferInLanes<Transfer, ShapeInLanes<Shape>>;

  /// m_i, (m v)_i, (12), (13)
  void scatter() {
    this->push_particles([&](int slot, const Vec2& dv) { transfer_.push(particles_, slot, dv); });
    const Vec2 dt_per_cell = time_step() * grid_.cell.cwiseInverse();
    const auto give = [&](int index, const auto& block, auto& to) __attribute__((flatten)) {
      transfer_.template give<Local<Force>>(particles_, index, block, shape_, dt_per_cell, to);
    };
    give_by_rows<Moved::given>(particles_.order, threads_, nodes_, give);
  }
  /// (10), (11), (14)
  void accelerate() {
    nodes_.find_mass(threads_);
    transfer_.accelerate(nodes_, walls_, time_step() * common_acceleration(scene_.body_force), *this, threads_);
  }
  /// (16), (17)
  void remap() {
    if constexpr (Moved::remaps) {
      transfer_.gather(nodes_, shape_, threads_, particles_);
      walls_.hold(nodes_, time() + time_step(), nodes_.strained);
      nodes_.edges.unfold(nodes_.strained);
    }
  }
  /// (18), (19), (32), (33), (15)
  void gather() {
    const StepOf<ShapeInLanes<Shape>, FluidLaw> step{grid_, shape_, scene_.fluid, time_step(), threads_, has_room_};
    GatherInLanes<Transfer, Density>::update(transfer_, nodes_, step, particles_, calm_);
  }

  void meet_walls(int slot, int cell) {
    contact_.meet(particles_.mass, grid_.place(cell, particles_.X[slot], particles_.Y[slot]),
                  [&](const Wall& wall) -> double& {
                    (wall.axis == 0 ? particles_.X : particles_.Y)[slot] = wall.inward > 0 ? 0 : 1;
                    return (wall.axis == 0 ? particles_.x : particles_.y).v[slot];
                  });
  }

  void begin_gradients() {
    if constexpr (std::derived_from<Density, AffineDensity>) {
      nodes_.expansion = Field<double>(nodes_.places());
      if (scene_.start.at_rest()) return;
      const auto expansion = [&](const Vec2& x) { return expansion_at(x, scene_.start, scene_.fluid); };
      particles_.order.for_each([&](int cell, int slot) {
        const Vec2 x = grid_.place(cell, particles_.X[slot], particles_.Y[slot]);
        particles_.gradient.along_x[slot] = grid_.cell.x() * slope_along(0, x, grid_, expansion);
        particles_.gradient.along_y[slot] = grid_.cell.y() * slope_along(1, x, grid_, expansion);
      });
    }
  }

  void list_near() {
    nodes_.list_near(particles_.order);
    walls_.list_near(nodes_);
    transfer_.make_room(particles_.order.blocks().size());
  }

  bool has_room_ = has_room(particles_.mass * static_cast<double>(particles_.count), scene_);
  ShapeInLanes<Shape> shape_;
  LaneWalls<Shape> walls_;
  WallContact contact_;
  Moved transfer_;
};

/// A simulation of a scene: `mpm::in_lanes<mpm::BSpline<2>, mpm::Apic, mpm::AffineDensity>(tank, {.cell = ...})`.
template <class Shape, class Transfer, class Density = CarriedDensity, class FluidLaw, class Force>
auto in_lanes(const Scene<FluidLaw, Force>& scene, const Settings& settings) {
  return InLanes<Shape, Transfer, Density, FluidLaw, Force>(scene, settings);
}

}  // namespace touchstone::mpm
