#pragma once
/// How densities follow the flow in cells, with what comes of them: stress and place.

#include "solvers/mpm/splines/transfers.hpp"

namespace touchstone::mpm {

/// What is the same for all particles of a step.
template <class FluidLaw>
struct StepOf {
  const Grid& grid;
  FluidLaw fluid;  // a copy, known not to change while particles are written
  double dt;       // s
  int threads;
  bool has_room;
  Vec2 per_cell = grid.cell.cwiseInverse();  // 1/m
};

/// The velocity by which the fluid is strained within a block.
struct StrainWithin {
  PowersOfBoth x, y;

  StrainWithin(const SplineNodes& nodes, int node)
      : x(laid_out(nodes, nodes.strained.x, node)), y(laid_out(nodes, nodes.strained.y, node)) {}

  /// (18)
  Slopes<Lanes> slopes(const Place& X, const Place& Y, const Vec2& per_cell) const {
    const Seen of_x = seen(x, X, Y, X.slope(), Y.slope()), of_y = seen(y, X, Y, X.slope(), Y.slope());
    return {.xx = per_cell.x() * of_x.along_x,
            .yx = per_cell.x() * of_y.along_x,
            .xy = per_cell.y() * of_x.along_y,
            .yy = per_cell.y() * of_y.along_y};
  }
};

/// Strains particles (18); their expansion (19).
template <class Particles, class FluidLaw, class Write>
Lanes strained(Particles& particles, int slot, const StrainWithin& velocity, const Place& X, const Place& Y,
               const StepOf<FluidLaw>& step, const Write& write) {
  const Slopes<Lanes> of_v = velocity.slopes(X, Y, step.per_cell);
  particles.stress.template keep_rates<Lanes>(slot, of_v, write);
  const Lanes before = load<Lanes>(&particles.expansion[slot]);
  return before + (1 + before) * (step.dt * of_v.divergence());
}

/// Density, stress (32), (33) and place (15); true if the particles are still in their cells, with plausible densities.
template <class Particles, class FluidLaw, class Write>
Truth<Lanes> settle_in(Particles& particles, int slot, const Place& X, const Place& Y, const Lanes& expansion,
                       const StepOf<FluidLaw>& step, const Write& write) {
  write(expansion, &particles.expansion[slot]);
  particles.stress.template update<Lanes>(slot, step.fluid, expansion,
                                          particles.stress.template kept_rates<Lanes>(slot), write);
  const Lanes to_x = X.X + step.dt * step.per_cell.x() * load<Lanes>(&particles.x.of_place()[slot]),
              to_y = Y.X + step.dt * step.per_cell.y() * load<Lanes>(&particles.y.of_place()[slot]);
  write(to_x, &particles.X[slot]);
  write(to_y, &particles.Y[slot]);
  return (between(0, to_x, 1) & between(0, to_y, 1) & between(1 / most_density, 1 + expansion, 1 / least_density)) |
         ~write.present;
}

template <class Density>
struct DensityInCells;

template <>
struct DensityInCells<CarriedDensity> {
  template <class Transfer, class Particles, class FluidLaw>
  static void update(const Transfer& transfer, SplineNodes& nodes, const StepOf<FluidLaw>& step, Particles& particles,
                     std::vector<LaneBits>& calm) {
    for_blocks(
        particles, nodes, step.threads, calm, [&](const auto& block, int node) __attribute__((flatten)) {
          const StrainWithin velocity(nodes, node);
          const typename Transfer::Taken taken(transfer, nodes, node);
          auto is_calm = calm_so_far;
          for_particles_of(block, [&](int slot, const auto& write) {
            const Place X(load<Lanes>(&particles.X[slot])), Y(load<Lanes>(&particles.Y[slot]));
            taken.take(particles, slot, X, Y, write);
            is_calm &=
                settle_in(particles, slot, X, Y, strained(particles, slot, velocity, X, Y, step, write), step, write);
          });
          return is_calm;
        });
  }
};

template <>
struct DensityInCells<AffineDensity> {
  template <class Transfer, class Particles, class FluidLaw>
  static void update(const Transfer& transfer, SplineNodes& nodes, const StepOf<FluidLaw>& step, Particles& particles,
                     std::vector<LaneBits>& calm) {
    give(transfer, nodes, step, particles);
    nodes.find_mean(0, nodes.expansion, step.threads);
    if (step.has_room) nodes.bound_expansion(step.threads);
    nodes.edges.unfold(nodes.expansion);
    for_blocks(
        particles, nodes, step.threads, calm, [&](const auto& block, int node) __attribute__((flatten)) {
          const PowersOfBoth expansion = laid_out(nodes, nodes.expansion, node);
          auto is_calm = calm_so_far;
          with_splines(step.grid, block, [&](const auto& splines_x, const auto& splines_y) {
            for_particles_of(block, [&](int slot, const auto& write) {
              const Place X(load<Lanes>(&particles.X[slot])), Y(load<Lanes>(&particles.Y[slot]));
              const Seen found = seen(expansion, X, Y, splines_x.affine_slope(X), splines_y.affine_slope(Y));
              write(found.along_x, &particles.gradient.along_x[slot]);
              write(found.along_y, &particles.gradient.along_y[slot]);
              is_calm &= settle_in(particles, slot, X, Y, found.value, step, write);
            });
          });
          return is_calm;
        });
  }

 private:
  template <class Transfer, class Particles, class FluidLaw>
  static void give(const Transfer& transfer, SplineNodes& nodes, const StepOf<FluidLaw>& step, Particles& particles) {
    const auto give_block = [&](int, const auto& block, auto& to) __attribute__((flatten)) {
      const int node = nodes.stride * block.row + block.column;
      const StrainWithin velocity(nodes, node);
      const typename Transfer::Taken taken(transfer, nodes, node);
      PowersOfBoth sums{};
      with_splines(step.grid, block, [&](const auto& splines_x, const auto& splines_y) {
        for_particles_of(block, [&](int slot, const auto& write) {
          const Place X(load<Lanes>(&particles.X[slot])), Y(load<Lanes>(&particles.Y[slot]));
          taken.take(particles, slot, X, Y, write);
          const Lanes expansion = strained(particles, slot, velocity, X, Y, step, write);
          add(sums, X, Y, write.present ? expansion : Lanes{},
              affine_turn(splines_x, X, load<Lanes>(&particles.gradient.along_x[slot])),
              affine_turn(splines_y, Y, load<Lanes>(&particles.gradient.along_y[slot])));
        });
      });
      to.give(0, block.column, nodes_of(sums));
    };
    give_by_rows<1>(particles.order, step.threads, nodes, give_block);
  }
};

}  // namespace touchstone::mpm
