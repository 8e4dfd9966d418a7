#pragma once
/// How densities follow the flow in lanes, with what comes of them: stress and place.

#include "solvers/mpm/lanes/particles_to_grid.hpp"

namespace touchstone::mpm {

/// What is the same for all particles of a step.
template <class Shape, class FluidLaw>
struct StepOf {
  const Grid& grid;
  const Shape& shape;  // in lanes
  FluidLaw fluid;      // a copy, known not to change while particles are written
  double dt;           // s
  int threads;
  bool has_room;
  Vec2 per_cell = grid.cell.cwiseInverse();  // 1/m
};

/// The velocity by which the fluid is strained within a block.
template <class Shape>
struct StrainWithin {
  typename Shape::Sums x, y;

  StrainWithin(const LaneNodes<Shape>& nodes, int node)
      : x(Shape::within(nodes, nodes.strained.x, node)), y(Shape::within(nodes, nodes.strained.y, node)) {}

  /// (18)
  template <class At>
  Slopes<Lanes> slopes(const At& X, const At& Y, const Vec2& per_cell) const {
    const ValueAndSlopes of_x = value_and_slopes(x, X, Y, X.slope(), Y.slope()),
                         of_y = value_and_slopes(y, X, Y, X.slope(), Y.slope());
    return {.xx = per_cell.x() * of_x.along_x,
            .yx = per_cell.x() * of_y.along_x,
            .xy = per_cell.y() * of_x.along_y,
            .yy = per_cell.y() * of_y.along_y};
  }
};

/// Strains particles (18); their expansion (19).
template <class Particles, class Velocity, class At, class Step, class Write>
Lanes strained(Particles& particles, int slot, const Velocity& velocity, const At& X, const At& Y, const Step& step,
               const Write& write) {
  const Slopes<Lanes> of_v = velocity.slopes(X, Y, step.per_cell);
  particles.stress.template keep_rates<Lanes>(slot, of_v, write);
  const Lanes before = load<Lanes>(&particles.expansion[slot]);
  return before + (1 + before) * (step.dt * of_v.divergence());
}

/// Place (15); true if the particles are still in their cells, with plausible densities.
template <class Particles, class Write>
Mask<Lanes> moved(Particles& particles, int slot, const Lanes& cells_x, const Lanes& cells_y, const Lanes& expansion,
                  const Write& write) {
  const Lanes to_x = load<Lanes>(&particles.X[slot]) + cells_x, to_y = load<Lanes>(&particles.Y[slot]) + cells_y;
  write(to_x, &particles.X[slot]);
  write(to_y, &particles.Y[slot]);
  return write.unless_absent(between(0, to_x, 1) & between(0, to_y, 1) &
                             between(1 / most_density, 1 + expansion, 1 / least_density));
}
/// Density, stress (32), (33) and place (15).
template <class Particles, class Step, class Write>
Mask<Lanes> settle_in(Particles& particles, int slot, const Lanes& expansion, const Step& step, const Write& write) {
  write(expansion, &particles.expansion[slot]);
  particles.stress.template update<Lanes>(slot, step.fluid, expansion,
                                          particles.stress.template kept_rates<Lanes>(slot), write);
  return moved(particles, slot, step.dt * step.per_cell.x() * load<Lanes>(&particles.x.of_place()[slot]),
               step.dt * step.per_cell.y() * load<Lanes>(&particles.y.of_place()[slot]), expansion, write);
}

template <class Density>
struct DensityInLanes;

template <>
struct DensityInLanes<CarriedDensity> {
  template <class Transfer, class Shape, class Particles, class FluidLaw>
  static void update(const Transfer& transfer, LaneNodes<Shape>& nodes, const StepOf<Shape, FluidLaw>& step,
                     Particles& particles, std::vector<LaneBits>& calm) {
    for_blocks(
        particles, nodes, step.threads, calm, [&](const auto& block, int node) __attribute__((flatten)) {
          const StrainWithin<Shape> velocity(nodes, node);
          const typename Transfer::Taken taken(transfer, nodes, node);
          auto is_calm = calm_so_far;
          step.shape.with(block, [&](const auto& along_x, const auto& along_y) {
            for_particles_of(block, [&](int slot, const auto& write) {
              const auto X = along_x.at(load<Lanes>(&particles.X[slot])),
                         Y = along_y.at(load<Lanes>(&particles.Y[slot]));
              taken.take(particles, slot, X, Y, write);
              is_calm &=
                  settle_in(particles, slot, strained(particles, slot, velocity, X, Y, step, write), step, write);
            });
          });
          return is_calm;
        });
  }
};

template <std::derived_from<AffineDensity> Density>
struct DensityInLanes<Density> {
  template <class Transfer, class Shape, class Particles, class FluidLaw>
  static void update(const Transfer& transfer, LaneNodes<Shape>& nodes, const StepOf<Shape, FluidLaw>& step,
                     Particles& particles, std::vector<LaneBits>& calm) {
    give(transfer, nodes, step, particles);
    nodes.find_mean(0, nodes.expansion, step.threads);
    if (step.has_room) nodes.bound_expansion(Density::most_expansion, step.threads);
    nodes.edges.unfold(nodes.expansion);
    for_blocks(
        particles, nodes, step.threads, calm, [&](const auto& block, int node) __attribute__((flatten)) {
          const auto expansion = Shape::within(nodes, nodes.expansion, node);
          auto is_calm = calm_so_far;
          step.shape.with_affine(block, [&](const auto& along_x, const auto& along_y) {
            for_particles_of(block, [&](int slot, const auto& write) {
              const auto X = along_x.at(load<Lanes>(&particles.X[slot])),
                         Y = along_y.at(load<Lanes>(&particles.Y[slot]));
              const ValueAndSlopes found =
                  value_and_slopes(expansion, X, Y, along_x.affine_slope(X), along_y.affine_slope(Y));
              write(found.along_x, &particles.gradient.along_x[slot]);
              write(found.along_y, &particles.gradient.along_y[slot]);
              is_calm &= settle_in(particles, slot, found.value, step, write);
            });
          });
          return is_calm;
        });
  }

 private:
  template <class Transfer, class Shape, class Particles, class FluidLaw>
  static void give(const Transfer& transfer, LaneNodes<Shape>& nodes, const StepOf<Shape, FluidLaw>& step,
                   Particles& particles) {
    const auto give_block = [&](int, const auto& block, auto& to) __attribute__((flatten)) {
      const int node = nodes.stride * block.row + block.column;
      const StrainWithin<Shape> velocity(nodes, node);
      const typename Transfer::Taken taken(transfer, nodes, node);
      typename Shape::Sums sums{};
      step.shape.with_affine(block, [&](const auto& along_x, const auto& along_y) {
        for_particles_of(block, [&](int slot, const auto& write) {
          const auto X = along_x.at(load<Lanes>(&particles.X[slot])), Y = along_y.at(load<Lanes>(&particles.Y[slot]));
          taken.take(particles, slot, X, Y, write);
          const Lanes expansion = strained(particles, slot, velocity, X, Y, step, write);
          add(sums, X, Y, write.present ? expansion : Lanes{},
              affine_extra(along_x, X, load<Lanes>(&particles.gradient.along_x[slot])),
              affine_extra(along_y, Y, load<Lanes>(&particles.gradient.along_y[slot])));
        });
      });
      to.give(0, block.column, nodes_of(sums));
    };
    give_by_rows<1>(particles.order, step.threads, nodes, give_block);
  }
};

/// All that particles take after the remap.
template <class Transfer, class Density>
struct GatherInLanes : DensityInLanes<Density> {};

}  // namespace touchstone::mpm
