#pragma once
/// Smoothed particle hydrodynamics with a transport velocity (Adami, Hu & Adams 2013): a background pressure moves the
/// particles, not the momentum, and keeps them evenly spread for any length of time. For fluid without a free surface.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/integrators/kick_drift_kick.hpp"
#include "solvers/integrators/predictor_corrector.hpp"
#include "solvers/sph/flow.hpp"
#include "solvers/sph/without.hpp"
#include "solvers/stepping/clock.hpp"
#include "solvers/stepping/extremes.hpp"

namespace touchstone::sph {

/// What a pair reads more: of the drift, the transport velocity less the velocity.
template <class Number>
struct DriftRecord : Record<Number> {
  Number mx, my;  // kg/m² s  density times drift
};

/// Density by continuity, kick-drift-kick, walls by ghosts with mirrored velocity (Adami, Hu & Adams 2012).
///
/// Adami, Hu & Adams sum the density anew each step and let the mean pressure of a pair act. In a channel both make the
/// lattice of particles elastic: a uniform pressure p resists its shear with a modulus of about 0.003 p, which bends
/// the straight profile of Couette flow by 2.1 % at 1 s. With continuity and `PressureDifference` it is 0.01 %.
template <class Kernel, class Integrator, class Real, class Left, class FluidLaw, class Force, class Terms>
class TransportVelocity : public Clock {
 public:
  TransportVelocity(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms)
      : Clock("sph", settings.time_step),
        scene_(scene),
        settings_(checked(settings)),
        terms_(terms),
        near_(scene, settings.spacing, reach_of<Kernel>(settings),
              lay_out_ghosts(scene.domain, scene.walls, settings.spacing, ghost_layers<Kernel>(settings)),
              settings.threads) {
    near_.carry(spreads ? 2 : 0, Integrator::past_fields);
  }

  /// The particles drift, then one step of the integrator. `lap` is told what was done.
  template <class Laps = NoLaps>
  void step(const Laps& lap = {}) {
    near_.follow(steps(), time(), time_step());
    lap(SubStep::sorting);
    drift(time_step());
    lap(SubStep::motion);
    integrator_.step(*this, time(), time_step(), lap);
    tick();
    if (steps() % 30 == 0) keep_volume();
    lap(SubStep::rates);
  }

  const Scene<FluidLaw, Force>& scene() const { return scene_; }
  Index particles() const { return near_.all.fluid; }
  Index boundary_particles() const { return near_.ghosts(); }
  /// Throws Diverged when a particle is outside the domain.
  Samples samples() const {
    near_.refuse_strays(steps(), time());
    return near_.samples(time(), scene_.fluid);
  }
  Extremes extremes() const { return extremes_of(near_.all); }

 private:
  friend Integrator;
  friend PredictorCorrector;  // starts others

  static constexpr double background_share = 0.1;  // of rho0 c²; more disturbs the flow, less is enough too
  static constexpr bool spreads = Left::template keeps<Spreading>;
  static constexpr bool drift_has_momentum = spreads && Left::template keeps<MomentumOfDrift>;
  using Seen = std::conditional_t<drift_has_momentum, DriftRecord<Real>, Record<Real>>;

  Particles& state() { return near_.all; }
  int threads() const { return settings_.threads; }
  // Carried with the particles: transport velocity less velocity [m/s].
  Scalars& wx() { return near_.all.carried[0]; }
  Scalars& wy() { return near_.all.carried[1]; }

  void drift(double dt) {
    if constexpr (spreads) {
      near_.all.x.head(near_.all.fluid) += dt * wx();
      near_.all.y.head(near_.all.fluid) += dt * wy();
    }
  }

  /// The fluid fills its domain, so the particles' volumes add up to what they were at the start. Continuity alone lets
  /// their sum creep, by 0.07 % in 10 s of Poiseuille flow, and with it the viscosity.
  void keep_volume() {
    if constexpr (Left::template keeps<VolumeKeeping>) {
      Scalars& rho = near_.all.rho;
      rho *= scene_.fluid.density / static_cast<double>(near_.all.fluid) * rho.inverse().sum();
    }
  }

  /// Rates of velocity and density, in one pass over the pairs.
  template <class Laps>
  void find_rates(double time, const Laps& lap) {
    look_around(time, lap);
    sum_pairs<true>();
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
    sum_pairs<false>();
    lap(SubStep::pairs);
    push(time, lap);
  }

  /// Fluid, ghosts and images as the last motion left them.
  template <class Laps>
  void look_around(double time, const Laps& lap) {
    if constexpr (drift_has_momentum) see_drift();
    near_.see_fluid(scene_.fluid);
    lap(SubStep::rates);
    move_ghosts<Kernel>(near_, scene_.walls, settings_.smoothing_length, scene_.fluid.density, time);
    lap(SubStep::boundaries);
  }

  void see_drift() {
    share_out_fields(threads(), near_.all.fluid, [&](Index begin, Index end) {
      const double *const rho = near_.all.rho.data(), *const drift_x = wx().data(), *const drift_y = wy().data();
      Seen* const seen = near_.seen.data();
      for (Index i = begin; i < end; ++i) {
        seen[i].mx = static_cast<Real>(rho[i] * drift_x[i]);
        seen[i].my = static_cast<Real>(rho[i] * drift_y[i]);
      }
    });
  }

  template <class Laps>
  void push(double time, const Laps& lap) {
    if constexpr (is_present<Force>) add_force(scene_.body_force, near_.all, time, threads());
    lap(SubStep::rates);
  }

  /// The listed terms of the momentum equation, what the drift of particles carries of momentum, the acceleration by a
  /// background pressure, -(p_b / m) sum_j (V_i² + V_j²) grad W, which spreads the particles, and continuity (23).
  template <bool with_density>
  void sum_pairs() {
    Particles& all = near_.all;
    const double c = scene_.fluid.sound_speed(), half_step = time_step() / 2;
    sum_over_neighbours<(spreads ? 5 : 3)>(
        near_.fluid_near_fluid, near_.seen,
        [terms = terms_, mass = all.mass, slope = Slope<Kernel>(settings_.smoothing_length),
         background = static_cast<Real>(background_share * scene_.fluid.density * c * c)](const auto& i,
                                                                                          const auto& j) {
          auto ij = pair_of(i, j, mass);
          auto pull = terms.on(ij, slope);
          const auto thicker = ij.continuity();
          if constexpr (spreads) {
            const auto share = ij.mass * ij.slope * (ij.volume_i * ij.volume_i + ij.volume_j * ij.volume_j);
            if constexpr (drift_has_momentum) pull += momentum_of_drift(ij, i, j, share);
            return std::array{thicker, pull.x, pull.y, -background * share * ij.x, -background * share * ij.y};
          } else {
            return std::array{thicker, pull.x, pull.y};
          }
        },
        [drho = all.drho.data(), ax = all.ax.data(), ay = all.ay.data(), drift_x = spreads ? wx().data() : nullptr,
         drift_y = spreads ? wy().data() : nullptr, half_step](Index i, const auto& sums) {
          if constexpr (with_density) drho[i] = sums[0];
          ax[i] = sums[1];
          ay[i] = sums[2];
          if constexpr (spreads) {
            drift_x[i] = half_step * sums[3];
            drift_y[i] = half_step * sums[4];
          }
        });
  }

  /// Half the mean of A = rho v (transport velocity - v) along grad W (Adami, Hu & Adams 2013, (8)).
  template <class Lane, class I, class J>
  static Pull<Lane> momentum_of_drift(const Pair<Lane>& ij, const I& i, const J& j, const Lane& share) {
    const auto m_i = i.two(&Seen::mx), m_j = j.two(&Seen::mx), v_i = i.two(&Seen::vx), v_j = j.two(&Seen::vx);
    const Lane out_i = m_i[0] * ij.x + m_i[1] * ij.y, out_j = m_j[0] * ij.x + m_j[1] * ij.y, c = Real(0.5) * share;
    return {c * (v_i[0] * out_i + v_j[0] * out_j), c * (v_i[1] * out_i + v_j[1] * out_j)};
  }

  Scene<FluidLaw, Force> scene_;
  Settings settings_;
  Terms terms_;
  Neighbourhood<Seen> near_;
  Integrator integrator_;
};

/// sph::transport_velocity<sph::QuinticSpline>(scene, {.spacing = ...}, sph::momentum(sph::PressureDifference{}, ...)),
/// sums in `Real`.
template <class Kernel, class Integrator = KickDriftKick, class Real = double, class Left = Without<>, class FluidLaw,
          class Force, class Terms>
auto transport_velocity(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms) {
  return TransportVelocity<Kernel, Integrator, Real, Left, FluidLaw, Force, Terms>(scene, settings, terms);
}

}  // namespace touchstone::sph
