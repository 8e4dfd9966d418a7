#pragma once
/// What all methods of smoothed particle hydrodynamics share: a scene with its particles, lists of neighbours, an
/// integrator and the step; and the answers that a run gives.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/integrators/predictor_corrector.hpp"
#include "solvers/sph/walls/mirrored_ghosts.hpp"
#include "solvers/stepping/clock.hpp"
#include "solvers/stepping/extremes.hpp"

namespace touchstone::sph {

/// A method derives from it as `Method`, sums over pairs of `Packed`s, and offers find<of_density, of_velocity>(time,
/// lap), which finds the rates of change that an integrator asks for; and what it does besides in a step.
template <class Method, class Kernel, class Integrator, class Packed, class FluidLaw, class Force>
class Simulation : public Clock {
 public:
  /// One step. `lap` is called at the end of each sub-step. Throws Diverged.
  void step(const Laps& lap = no_laps) {
    method().spread_particles();
    lap(SubStep::motion);
    near_.follow(steps(), time(), time_step());
    lap(SubStep::sorting);
    integrator_.step(*this, time(), time_step(), lap);
    tick();
    method().correct_density();
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
  const Integrator& integrator() const { return integrator_; }

 protected:
  /// Throws std::invalid_argument for settings that are not positive, and as `Neighbourhood` does. `carried` fields of
  /// the method go with the fluid.
  Simulation(const Scene<FluidLaw, Force>& scene, const Settings& settings, std::size_t carried, const ListReach& reach,
             BoundaryLayout layout)
      : Clock("sph", settings.time_step),
        scene_(scene),
        settings_(settings),
        near_(scene, settings.spacing, reach, std::move(layout), settings.threads) {
    near_.carry(carried, Integrator::past_fields);
  }
  /// With ghosts behind its walls and nothing on them.
  Simulation(const Scene<FluidLaw, Force>& scene, const Settings& settings, std::size_t carried)
      : Simulation(scene, settings, carried, reach_of<Kernel>(settings),
                   lay_out_ghosts(scene.domain, scene.walls, settings.spacing, ghost_layers<Kernel>(settings))) {}

  /// What a method has particles do, beyond their velocity, to stay evenly spread: nothing.
  static void spread_particles() {}
  /// What a method does to densities after a step, beyond continuity: nothing.
  static void correct_density() {}

  /// Fluid, mirrored ghosts and images as the last motion left them.
  void see_fluid_and_ghosts(double time, const Laps& lap) {
    near_.see_fluid(scene_.fluid);
    lap(SubStep::rates);
    mirror_to_ghosts<Kernel>(near_, scene_.walls, smoothing_length(), scene_.fluid.density, time);
    lap(SubStep::boundaries);
  }
  void add_body_force(double time, const Laps& lap) {
    if constexpr (is_present<Force>) add_force(scene_.body_force, near_.all, time, threads());
    lap(SubStep::rates);
  }
  double smoothing_length() const { return settings_.smoothing_length; }  // m  h
  double spacing() const { return settings_.spacing; }                    // m
  int threads() const { return settings_.threads; }

  Scene<FluidLaw, Force> scene_;
  Settings settings_;
  Neighbourhood<Packed> near_;

 private:
  friend Integrator;
  friend PredictorCorrector;  // starts others

  Method& method() { return static_cast<Method&>(*this); }
  Particles& state() { return near_.all; }
  void find_rates(double time, const Laps& lap) {
    method().template find<true, true>(time, lap);
  }
  void find_density_rate(double time, const Laps& lap) {
    method().template find<true, false>(time, lap);
  }
  void find_accelerations(double time, const Laps& lap) {
    method().template find<false, true>(time, lap);
  }
  /// What a method does to velocities before they move particles.
  void before_drift(double time, double dt) {
    if constexpr (requires(Method & method) { method.meet_walls(time, dt); }) method().meet_walls(time, dt);
  }

  Integrator integrator_;
};

}  // namespace touchstone::sph
