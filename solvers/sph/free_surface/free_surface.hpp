#pragma once
/// Weakly compressible smoothed particle hydrodynamics for fluid with a free surface, from parts that are chosen by
/// type: how pressure pulls, what diffuses density, what corrects the gradient of the kernel, what shifts particles.
/// With `Antuono` it is delta-SPH (Antuono et al. 2010), with shifting too delta-plus-SPH (Sun et al. 2017).

#include "solvers/fluids/newtonian.hpp"
#include "solvers/integrators/kick_drift_kick.hpp"
#include "solvers/integrators/predictor_corrector.hpp"
#include "solvers/sph/free_surface/diffusion/none.hpp"
#include "solvers/sph/free_surface/gradients/plain.hpp"
#include "solvers/sph/free_surface/shifting/none.hpp"
#include "solvers/sph/free_surface/surroundings.hpp"
#include "solvers/sph/terms/pressure_sum.hpp"
#include "solvers/sph/walls/balanced_ghosts.hpp"
#include "solvers/stepping/clock.hpp"
#include "solvers/stepping/extremes.hpp"

namespace touchstone::sph {

/// The parts of a method for free surfaces. Pressures are added, not subtracted, where there is a surface: a sum over
/// fluid alone takes the pressure beyond as zero, and a difference takes none, so that its surface is unstable.
template <class Pressure = PressureSum, class Diffusion = NoDiffusion, class Gradient = PlainGradient,
          class Shifting = NoShifting>
struct Parts {
  Pressure pressure{};
  Diffusion diffusion{};
  Gradient gradient{};
  Shifting shifting{};
};

/// Writes the rates of density, by continuity, -rho_i sum_j V_j (v_j - v_i) · grad W, and diffusion, and of velocity,
/// by pressure and the terms listed besides; only those that are expected.
template <class Kernel, bool of_density, bool of_velocity, class Record, class Terms, class PartsOfMethod>
void sum_rates(Neighbourhood<Record>& near, const Terms& terms, const PartsOfMethod& parts, double h) {
  Particles& all = near.all;
  sum_over_neighbours<3>(
      near.fluid_near_fluid, near.seen,
      [terms, parts, mass = all.mass, slope = Slope<Kernel>(h)](const auto& i, const auto& j) {
        auto ij = pair_of(i, j, mass);
        using Real = std::remove_cvref_t<decltype(ij.r)>;
        auto pull = terms.on(ij, slope);
        std::array<Real, 3> rates{};
        if constexpr (of_density) {
          const Pull<Real> along = parts.gradient(i, j, Pull<Real>{ij.slope * ij.x, ij.slope * ij.y});
          rates[0] = ij.rho_i * ij.mass * ij.volume_j * (ij.vx * along.x + ij.vy * along.y);
          if constexpr (is_present<decltype(PartsOfMethod::diffusion)>) rates[0] += parts.diffusion.rate(ij, i, j);
        }
        if constexpr (of_velocity) {
          if constexpr (LooksAround<decltype(PartsOfMethod::pressure)>)
            pull += parts.pressure(ij, i, j);
          else
            pull += parts.gradient(i, j, parts.pressure(ij));
          rates[1] = pull.x;
          rates[2] = pull.y;
        }
        return rates;
      },
      [drho = all.drho.data(), ax = all.ax.data(), ay = all.ay.data()](Index i, const std::array<double, 3>& sums) {
        if constexpr (of_density) drho[i] = sums[0];
        if constexpr (of_velocity) {
          ax[i] = sums[1];
          ay[i] = sums[2];
        }
      });
}

/// Continuity density, fixed wall particles that balance the fluid (Adami, Hu & Adams 2012), kick-drift-kick.
template <class Kernel, class Integrator, class Real, class FluidLaw, class Force, class Terms, class PartsOfMethod>
class FreeSurface : public Clock {
 public:
  FreeSurface(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms,
              const PartsOfMethod& parts)
      : Clock("sph", settings.time_step),
        scene_(scene),
        settings_(checked(settings)),
        terms_(terms),
        parts_(parts),
        near_(scene, settings.spacing, reach_of<Kernel>(settings),
              lay_out_ghosts(scene.domain, scene.walls, settings.spacing, ghost_layers<Kernel>(settings)),
              settings.threads) {
    near_.carry(0, Integrator::past_fields);
  }

  /// The particles are shifted, then one step of the integrator. `lap` is told what was done.
  template <class Laps = NoLaps>
  void step(const Laps& lap = {}) {
    shift(lap);
    near_.follow(steps(), time(), time_step());
    lap(SubStep::sorting);
    integrator_.step(*this, time(), time_step(), lap);
    tick();
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

  static constexpr bool corrects = LooksAround<decltype(PartsOfMethod::gradient)> ||
                                   LooksAround<decltype(PartsOfMethod::pressure)>,
                        diffuses_rise = LooksAround<decltype(PartsOfMethod::diffusion)>,
                        shifts = is_present<decltype(PartsOfMethod::shifting)>;
  using Seen = std::conditional_t<corrects || diffuses_rise || shifts, Surroundings<Real>, Record<Real>>;

  Particles& state() { return near_.all; }
  int threads() const { return settings_.threads; }

  /// Rates of velocity and density, in one pass over the pairs.
  template <class Laps>
  void find_rates(double time, const Laps& lap) {
    find<true, true>(time, lap);
  }
  template <class Laps>
  void find_density_rate(double time, const Laps& lap) {
    find<true, false>(time, lap);
  }
  template <class Laps>
  void find_accelerations(double time, const Laps& lap) {
    find<false, true>(time, lap);
  }

  template <bool of_density, bool of_velocity, class Laps>
  void find(double time, const Laps& lap) {
    look_around<corrects || (of_density && diffuses_rise)>(time, lap);
    if constexpr (of_density && diffuses_rise) carry_rise_to_ghosts<Kernel>(near_, settings_.smoothing_length);
    sum_rates<Kernel, of_density, of_velocity>(near_, terms_, parts_, settings_.smoothing_length);
    lap(SubStep::pairs);
    if constexpr (of_velocity && is_present<Force>) add_force(scene_.body_force, near_.all, time, threads());
    lap(SubStep::rates);
  }

  /// Fluid, ghosts and images as the last motion left them, and their surroundings if expected.
  template <bool surroundings, class Laps>
  void look_around(double time, const Laps& lap) {
    near_.see_fluid(scene_.fluid);
    lap(SubStep::rates);
    balance_ghosts<Kernel>(near_, scene_.walls, settings_.smoothing_length, scene_.fluid, scene_.body_force, time);
    lap(SubStep::boundaries);
    if constexpr (surroundings) find_surroundings<Kernel>(near_, settings_.smoothing_length);
    lap(SubStep::pairs);
  }

  template <class Laps>
  void shift(const Laps& lap) {
    if constexpr (shifts) {
      look_around<true>(time(), lap);
      parts_.shifting.template shift<Kernel>(near_, settings_.smoothing_length, settings_.spacing, time_step());
      lap(SubStep::motion);
    }
  }

  Scene<FluidLaw, Force> scene_;
  Settings settings_;
  Terms terms_;
  PartsOfMethod parts_;
  Neighbourhood<Seen> near_;
  Integrator integrator_;
};

/// sph::free_surface<sph::WendlandC2>(scene, {.spacing = ...}, sph::momentum(sph::ArtificialViscosity{...}),
/// sph::Parts{.pressure = sph::PressureSum{}, .diffusion = sph::Antuono{...}}), sums in `Real`.
template <class Kernel, class Integrator = KickDriftKick, class Real = double, class FluidLaw, class Force, class Terms,
          class PartsOfMethod>
auto free_surface(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms,
                  const PartsOfMethod& parts) {
  return FreeSurface<Kernel, Integrator, Real, FluidLaw, Force, Terms, PartsOfMethod>(scene, settings, terms, parts);
}

}  // namespace touchstone::sph
