#pragma once
/// Smoothed particle hydrodynamics as printed by Sun et al., sections 2.2 to 2.5.

#include "solvers/sph/printed/smoothing.hpp"
#include "solvers/sph/simulation.hpp"
#include "solvers/sph/walls/repulsion.hpp"
#include "solvers/sph/without.hpp"

namespace touchstone::sph {

/// Continuity density, predictor-corrector, density restored every 30 steps, ghosts and soft repulsion at walls.
template <class Kernel, class Integrator, class Real, class Left, class FluidLaw, class Force, class Terms>
class Printed : public Simulation<Printed<Kernel, Integrator, Real, Left, FluidLaw, Force, Terms>, Kernel, Integrator,
                                  Record<Real>, FluidLaw, Force> {
  using Base = Simulation<Printed, Kernel, Integrator, Record<Real>, FluidLaw, Force>;
  using Base::near_, Base::scene_, Base::settings_;

 public:
  using Base::steps;

  Printed(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms)
      : Base(scene, settings, 0, reach_of<Kernel>(settings, repels ? SoftRepulsion<0>::reach(settings.spacing) : 0, 5),
             lay_out_ghosts_and_walls(scene.domain, scene.walls, settings.spacing, ghost_layers<Kernel>(settings))),
        terms_(terms) {}

  /// One step of the integrator, section 2.4, and every so often the density restored. `lap` is called at the end of
  /// each sub-step.
  template <class Laps = NoLaps>
  void step(const Laps& lap = {}) {
    this->list_neighbours(lap);
    this->advance(lap);
    this->tick();
    if (steps() % steps_between_restorations == 0) restore();  // (29), (30)
    lap(SubStep::rates);
  }

 private:
  friend Base;

  static constexpr long steps_between_restorations = 30;
  static constexpr bool repels = Left::template keeps<Repulsion>;

  void restore() {
    if constexpr (Left::template keeps<Restoration>) {
      near_.see_fluid(scene_.fluid);
      restore_density<Kernel>(near_, this->smoothing_length());
    }
  }

  /// Rates of velocity and density, in one pass over the pairs.
  template <bool of_density, bool of_velocity, class Laps>
  void find(double time, const Laps& lap) {
    this->see_fluid_and_ghosts(time, lap);
    if constexpr (of_velocity)
      sum_pairs<of_density>();
    else
      find_continuity<Kernel>(near_, this->smoothing_length());
    lap(SubStep::pairs);
    if constexpr (of_velocity) {
      push_off_walls(lap);
      this->add_body_force(time, lap);
    }
  }

  /// Continuity (23) and momentum (28), only the terms that this method lists.
  template <bool of_density>
  void sum_pairs() {
    Particles& all = near_.all;
    sum_over_neighbours<3>(
        near_.fluid_near_fluid, near_.seen,
        [terms = terms_, mass = all.mass, slope = this->slope()](const auto& i, const auto& j) {
          auto ij = pair_of(i, j, mass);
          const auto pull = terms.on(ij, slope);
          return std::array{ij.continuity(), pull.x, pull.y};
        },
        [drho = all.drho.data(), ax = all.ax.data(), ay = all.ay.data()](Index i, const std::array<double, 3>& sums) {
          if constexpr (of_density) drho[i] = sums[0];
          ax[i] = sums[1];
          ay[i] = sums[2];
        });
  }

  template <class Laps>
  void push_off_walls(const Laps& lap) {
    if constexpr (repels) {
      repel<0>();
      repel<1>();
      lap(SubStep::boundaries);
    }
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

  Terms terms_;
};

/// sph::printed<sph::CubicSpline>(scene, {.spacing = ...}, sph::momentum(sph::Pressure{}, ...)); sums in `Real`.
template <class Kernel, class Integrator = PredictorCorrector, class Real = double, class Left = Without<>,
          class FluidLaw, class Force, class Terms>
auto printed(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms) {
  return Printed<Kernel, Integrator, Real, Left, FluidLaw, Force, Terms>(scene, settings, terms);
}

}  // namespace touchstone::sph
