#pragma once
/// Smoothed particle hydrodynamics as printed by Sun et al., sections 2.2 to 2.5.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/integrators/predictor_corrector.hpp"
#include "solvers/sph/flow.hpp"
#include "solvers/sph/printed/smoothing.hpp"
#include "solvers/sph/walls/repulsion.hpp"
#include "solvers/sph/without.hpp"
#include "solvers/stepping/clock.hpp"
#include "solvers/stepping/extremes.hpp"

namespace touchstone::sph {

/// Continuity density, predictor-corrector, density restored every 30 steps, ghosts and soft repulsion at walls.
template <class Kernel, class Integrator, class Real, class Left, class FluidLaw, class Force, class Terms>
class Printed : public Clock {
 public:
  Printed(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms)
      : Clock("sph", settings.time_step),
        scene_(scene),
        settings_(checked(settings)),
        terms_(terms),
        near_(scene, settings.spacing,
              {.kernel = Kernel::support * settings.smoothing_length,
               .wall = repels ? SoftRepulsion<0>::reach(settings.spacing) : 0,
               .skin = skin * settings.spacing,
               .least_skin = skin * settings.spacing,
               .greatest_skin = 5 * skin * settings.spacing},
              lay_out_ghosts_and_walls(scene.domain, scene.walls, settings.spacing, ghost_layers<Kernel>(settings)),
              settings.threads) {
    near_.carry(0, Integrator::past_fields);
  }

  /// One step of the integrator, section 2.4, and every so often the density restored. `lap` is told what was done.
  template <class Laps = NoLaps>
  void step(const Laps& lap = {}) {
    near_.follow(steps(), time(), time_step());
    lap(SubStep::sorting);
    integrator_.step(*this, time(), time_step(), lap);
    tick();
    if (steps() % steps_between_restorations == 0) restore();  // (29), (30)
    lap(SubStep::rates);
  }

  const Scene<FluidLaw, Force>& scene() const { return scene_; }
  Index particles() const { return near_.all.fluid; }
  Index boundary_particles() const { return near_.all.boundary; }
  /// Throws Diverged when a particle is outside the domain.
  Samples samples() const {
    near_.refuse_strays(steps(), time());
    return near_.samples(time(), scene_.fluid);
  }
  Extremes extremes() const { return extremes_of(near_.all); }

 private:
  friend Integrator;
  friend PredictorCorrector;  // starts others

  static constexpr long steps_between_restorations = 30;
  static constexpr double skin = 0.1;  // spacings; lists last a hundred steps in a channel, a few in a splash
  static constexpr bool repels = Left::template keeps<Repulsion>;

  Particles& state() { return near_.all; }
  int threads() const { return settings_.threads; }

  void restore() {
    if constexpr (Left::template keeps<Restoration>) {
      near_.see_fluid(scene_.fluid);
      restore_density<Kernel>(near_, settings_.smoothing_length);
    }
  }

  /// Rates of velocity and density, in one pass over the pairs.
  template <class Laps>
  void find_rates(double time, const Laps& lap) {
    look_around(time, lap);
    sum_pairs();
    lap(SubStep::pairs);
    push(time, lap);
  }
  template <class Laps>
  void find_density_rate(double time, const Laps& lap) {
    look_around(time, lap);
    find_continuity<Kernel>(near_, settings_.smoothing_length);
    lap(SubStep::pairs);
  }
  template <class Laps>
  void find_accelerations(double time, const Laps& lap) {
    look_around(time, lap);
    sum_momentum();
    lap(SubStep::pairs);
    push(time, lap);
  }

  template <class Laps>
  void look_around(double time, const Laps& lap) {
    near_.see_fluid(scene_.fluid);
    lap(SubStep::rates);
    move_ghosts<Kernel>(near_, scene_.walls, settings_.smoothing_length, scene_.fluid.density, time);
    lap(SubStep::boundaries);
  }

  /// Continuity (23) and momentum (28), only the terms that this method lists.
  void sum_pairs() {
    Particles& all = near_.all;
    sum_over_neighbours<3>(
        near_.fluid_near_fluid, near_.seen,
        [terms = terms_, mass = all.mass, slope = Slope<Kernel>(settings_.smoothing_length)](const auto& i,
                                                                                             const auto& j) {
          auto ij = pair_of(i, j, mass);
          const auto pull = terms.on(ij, slope);
          return std::array{ij.continuity(), pull.x, pull.y};
        },
        [drho = all.drho.data(), ax = all.ax.data(), ay = all.ay.data()](Index i, const std::array<double, 3>& sums) {
          drho[i] = sums[0];
          ax[i] = sums[1];
          ay[i] = sums[2];
        });
  }
  void sum_momentum() {
    Particles& all = near_.all;
    sum_over_neighbours<2>(
        near_.fluid_near_fluid, near_.seen,
        [terms = terms_, mass = all.mass, slope = Slope<Kernel>(settings_.smoothing_length)](const auto& i,
                                                                                             const auto& j) {
          auto ij = pair_of(i, j, mass);
          const auto pull = terms.on(ij, slope);
          return std::array{pull.x, pull.y};
        },
        [ax = all.ax.data(), ay = all.ay.data()](Index i, const std::array<double, 2>& sums) {
          ax[i] = sums[0];
          ay[i] = sums[1];
        });
  }

  template <class Laps>
  void push(double time, const Laps& lap) {
    if constexpr (repels) {
      repel<0>();
      repel<1>();
      lap(SubStep::boundaries);
    }
    if constexpr (is_present<Force>) add_force(scene_.body_force, near_.all, time, threads());
    lap(SubStep::rates);
  }

  /// The push of the walls of constant x (`axis` 0) or y (1).
  template <int axis>
  void repel() {
    Particles& all = near_.all;
    const SoftRepulsion<axis> push{scene_.fluid.sound_speed(), settings_.spacing};
    sum_over_neighbours<2>(
        near_.wall_near_fluid[axis], near_.seen,
        [push, mass = all.mass](const auto& i, const auto& j) {
          const auto pull = push(pair_of(i, j, mass));
          return std::array{pull.x, pull.y};
        },
        [&](Index i, const std::array<double, 2>& sums) { (axis == 0 ? all.ax : all.ay)[i] += sums[axis]; });
  }

  Scene<FluidLaw, Force> scene_;
  Settings settings_;
  Terms terms_;
  Neighbourhood<Record<Real>> near_;
  Integrator integrator_;
};

/// sph::printed<sph::CubicSpline>(scene, {.spacing = ...}, sph::momentum(sph::Pressure{}, ...)); sums in `Real`.
template <class Kernel, class Integrator = PredictorCorrector, class Real = double, class Left = Without<>,
          class FluidLaw, class Force, class Terms>
auto printed(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms) {
  return Printed<Kernel, Integrator, Real, Left, FluidLaw, Force, Terms>(scene, settings, terms);
}

}  // namespace touchstone::sph
