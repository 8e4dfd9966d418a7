#pragma once
/// Smoothed particle hydrodynamics as printed by Sun et al., sections 2.2 to 2.5.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/sph/momentum.hpp"
#include "solvers/sph/neighbourhood.hpp"
#include "solvers/sph/settings.hpp"
#include "solvers/sph/smoothing.hpp"
#include "solvers/sph/walls/repulsion.hpp"

namespace touchstone::sph {

/// Continuity density, predictor-corrector, density restored every 30 steps, ghosts and soft repulsion at walls.
template <class Kernel, class FluidLaw, class Force, class Terms>
class Printed {
 public:
  Printed(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms)
      : scene_(scene),
        settings_(checked(settings)),
        terms_(terms),
        near_(scene.domain, scene.filled, scene.fluid.density, settings.spacing,
              Kernel::support * settings.smoothing_length, skin * settings.spacing,
              lay_out_ghosts_and_walls(scene.domain, scene.walls, settings.spacing, ghost_layers<Kernel>(settings))) {
    for (Scalars* field : {&rates_.rho, &rates_.vx, &rates_.vy}) field->setZero(near_.all.fluid);
    for (Scalars& sum : push_) sum.setZero(near_.all.fluid);
    for (Scalars& sum : ghost_sums_) sum.setZero(near_.ghosts());
    for (Scalars& sum : density_sums_) sum.setZero(near_.all.fluid);
  }

  /// One predictor-corrector step, section 2.4.
  void step() {
    near_.follow(steps_, time_, time_step());
    remember_start();
    find_rates(time_);
    advance(time_step() / 2);  // predict the midpoint
    find_rates(time_ + time_step() / 2);
    advance(time_step());                                       // correct from the start
    if (++steps_ % steps_between_restorations == 0) restore();  // (29), (30)
    time_ = static_cast<double>(steps_) * time_step();
  }

  double time() const { return time_; }                     // s
  double time_step() const { return settings_.time_step; }  // s
  long steps() const { return steps_; }
  Index particles() const { return near_.all.fluid; }
  Index boundary_particles() const { return near_.all.boundary; }
  /// Throws Diverged when a particle is outside the domain.
  Samples samples() const {
    near_.refuse_strays(steps_, time_);
    return near_.samples(time_, scene_.fluid);
  }

 private:
  struct Motion {
    Scalars x, y, vx, vy, rho;
  };

  static constexpr long steps_between_restorations = 30;
  static constexpr double skin = 0.3;  // spacings; lists last some hundred steps in a channel, a few in a splash

  void remember_start() {
    const Particles& all = near_.all;
    start_.x = all.x.head(all.fluid);
    start_.y = all.y.head(all.fluid);
    start_.vx = all.vx.head(all.fluid);
    start_.vy = all.vy.head(all.fluid);
    start_.rho = all.rho.head(all.fluid);
  }

  void restore() {
    near_.images.refresh_fluid(near_.all);
    restore_density<Kernel>(near_.all, near_.fluid_near_fluid, settings_.smoothing_length, density_sums_);
  }

  void find_rates(double time) {
    Particles& all = near_.all;
    find_pressure();
    near_.images.refresh_fluid(all);
    fill_ghosts<Kernel>(all, near_.fluid_near_ghost, near_.boundary.ghosts, scene_.walls, settings_.smoothing_length,
                        scene_.fluid.density, time, ghost_sums_);
    near_.images.refresh_boundary(all);
    sum_pairs();
    repel<0>();
    repel<1>();
    if constexpr (is_present<Force>) add_force(scene_.body_force, near_.all, time, rates_.vx, rates_.vy);
  }

  void find_pressure() {
    Particles& all = near_.all;
    for (Index i = 0; i < all.fluid; ++i) all.p[i] = scene_.fluid.pressure(all.rho[i]);  // (33)
  }

  /// Continuity (23) and momentum (28), only the terms that this method lists.
  void sum_pairs() {
    const Particles& all = near_.all;
    sum_over_neighbours<3>(near_.fluid_near_fluid, {rates_.rho.data(), rates_.vx.data(), rates_.vy.data()},
                           [&, h = settings_.smoothing_length](Block i, Row j) -> std::array<Lanes, 3> {
                             const Pair<Lanes> ij = pair_of<Kernel>(all, i, j, h);
                             const Pull<Lanes> pull = terms_(ij);
                             return {ij.mass * ij.slope * ij.approach(), pull.x, pull.y};
                           });
  }

  /// The push of the walls of constant x (`axis` 0) or y (1).
  template <int axis>
  void repel() {
    const Particles& all = near_.all;
    const SoftRepulsion<axis> push{scene_.fluid.sound_speed(), settings_.spacing};
    sum_over_neighbours<2>(near_.wall_near_fluid[axis], {push_[0].data(), push_[1].data()},
                           [&](Block i, Row j) -> std::array<Lanes, 2> {
                             const Pull<Lanes> pull = push(pair_of<Kernel>(all, i, j, settings_.smoothing_length));
                             return {pull.x, pull.y};
                           });
    (axis == 0 ? rates_.vx : rates_.vy) += push_[axis];
  }

  /// From the start of the step, over `dt` [s], with the rates found last.
  void advance(double dt) {
    Particles& all = near_.all;
    all.x.head(all.fluid) = start_.x + dt * all.vx.head(all.fluid);
    all.y.head(all.fluid) = start_.y + dt * all.vy.head(all.fluid);
    all.vx.head(all.fluid) = start_.vx + dt * rates_.vx;
    all.vy.head(all.fluid) = start_.vy + dt * rates_.vy;
    all.rho.head(all.fluid) = start_.rho + dt * rates_.rho;
  }

  Scene<FluidLaw, Force> scene_;
  Settings settings_;
  Terms terms_;
  Neighbourhood near_;
  Motion start_;
  struct {
    Scalars rho, vx, vy;  // kg/m³ s, m/s²
  } rates_;
  std::array<Scalars, 2> push_;  // m/s²
  std::array<Scalars, 5> ghost_sums_;
  std::array<Scalars, 2> density_sums_;
  double time_ = 0;
  long steps_ = 0;
};

/// sph::printed<sph::CubicSpline>(scene, {.spacing = ...}, sph::momentum(sph::Pressure{}, ...))
template <class Kernel, class FluidLaw, class Force, class Terms>
auto printed(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms) {
  return Printed<Kernel, FluidLaw, Force, Terms>(scene, settings, terms);
}

}  // namespace touchstone::sph
