#pragma once
/// What particles take whose affine velocity holds the stress (`MlsApic`), all in one pass.

#include "solvers/mpm/lanes/grid_to_particles.hpp"

namespace touchstone::mpm {

/// What a particle keeps of a velocity and its slopes: of these the stress (32), (33) takes what it gives in a step
/// over the spread of the weights, a quarter of a cell squared.
template <class FluidLaw, class Density, class Write>
void keep(LaneParticles<FluidLaw, MlsApic, Density>& particles, int slot, const FluidLaw& fluid, const Lanes& expansion,
          const ValueAndSlopes& x, const ValueAndSlopes& y, const Vec2& per_cell, double dt, const Write& write) {
  const Lanes specific_volume = fill<Lanes>(1 / fluid.density) * (1 + expansion), p = pressure_of(fluid, expansion);
  Lanes xx = -p, yy = -p, xy{};
  if constexpr (Viscous<FluidLaw>) {
    // Pa s/m  over the sides of a cell
    const Lanes mu_x = fill<Lanes>(fluid.viscosity * per_cell.x()), mu_y = fill<Lanes>(fluid.viscosity * per_cell.y());
    const Lanes mu_xx = mu_x * x.along_x, mu_yy = mu_y * y.along_y;
    const Lanes bulk = fill<Lanes>(2.0 / 3) * (mu_xx + mu_yy);
    xx += 2 * mu_xx - bulk;
    yy += 2 * mu_yy - bulk;
    xy = mu_y * x.along_y + mu_x * y.along_x;
  }
  const Lanes given_x = fill<Lanes>(4 * dt * per_cell.x()) * specific_volume,
              given_y = fill<Lanes>(4 * dt * per_cell.y()) * specific_volume;
  write(x.value, &particles.x.v[slot]);
  write(y.value, &particles.y.v[slot]);
  write(x.along_x - given_x * xx, &particles.x.along_x[slot]);
  write(x.along_y - given_y * xy, &particles.x.along_y[slot]);
  write(y.along_x - given_x * xy, &particles.y.along_x[slot]);
  write(y.along_y - given_y * yy, &particles.y.along_y[slot]);
  write(expansion, &particles.expansion[slot]);
}

/// Sets a particle going, with the affine velocity of its velocity's slopes and the stress of these and its density.
template <class FluidLaw, class Density>
void begin(LaneParticles<FluidLaw, MlsApic, Density>& particles, int slot, const Beginning& there,
           const FluidLaw& fluid, const Vec2& cell, double dt) {
  const auto seen_there = [&](double v, double along_x, double along_y) -> ValueAndSlopes {
    return {fill<Lanes>(v), fill<Lanes>(cell.x() * along_x), fill<Lanes>(cell.y() * along_y)};
  };
  keep(particles, slot, fluid, fill<Lanes>(there.expansion), seen_there(there.v.x(), there.of.xx, there.of.xy),
       seen_there(there.v.y(), there.of.yx, there.of.yy), cell.cwiseInverse(), dt, FirstLane{});
}

/// v_p, C_p, x_p, rho_p, (32), (33)
template <>
struct GatherInLanes<MlsApic, CarriedDensity> {
  template <class Transfer, class Shape, class Particles, class FluidLaw>
  static void update(const Transfer&, const LaneNodes<Shape>& nodes, const StepOf<Shape, FluidLaw>& step,
                     Particles& particles, std::vector<LaneBits>& calm) {
    for_blocks(
        particles, nodes, step.threads, calm, [&](const auto& block, int node) __attribute__((flatten)) {
          const auto of_x = Shape::within(nodes, nodes.velocity.x, node),
                     of_y = Shape::within(nodes, nodes.velocity.y, node);
          auto is_calm = calm_so_far;
          step.shape.with_affine(block, [&](const auto& along_x, const auto& along_y) {
            for_particles_of(block, [&](int slot, const auto& write) {
              const auto X = along_x.at(load<Lanes>(&particles.X[slot])),
                         Y = along_y.at(load<Lanes>(&particles.Y[slot]));
              const Lanes bend_x = along_x.affine_slope(X), bend_y = along_y.affine_slope(Y);
              const ValueAndSlopes x = value_and_slopes(of_x, X, Y, bend_x, bend_y),
                                   y = value_and_slopes(of_y, X, Y, bend_x, bend_y);
              const Lanes cells_x = fill<Lanes>(step.dt * step.per_cell.x()),
                          cells_y = fill<Lanes>(step.dt * step.per_cell.y());
              const Lanes before = load<Lanes>(&particles.expansion[slot]);
              const Lanes after = before + (1 + before) * (cells_x * x.along_x + cells_y * y.along_y);
              keep(particles, slot, step.fluid, after, x, y, step.per_cell, step.dt, write);
              is_calm &= moved(particles, slot, cells_x * x.value, cells_y * y.value, after, write);
            });
          });
          return is_calm;
        });
  }
};

}  // namespace touchstone::mpm
