#pragma once
/// Weakly compressible smoothed particle hydrodynamics for fluid with a free surface, from parts that are chosen by
/// type: how pressure pulls, what diffuses density, what corrects the gradient of the kernel, what shifts particles.
/// With `Antuono` it is delta-SPH (Antuono et al. 2010), with shifting too delta-plus-SPH (Sun et al. 2017).

#include "solvers/integrators/kick_drift_kick.hpp"
#include "solvers/sph/free_surface/gradients/plain.hpp"
#include "solvers/sph/free_surface/none.hpp"
#include "solvers/sph/free_surface/surroundings.hpp"
#include "solvers/sph/simulation.hpp"
#include "solvers/sph/terms/pressure_sum.hpp"
#include "solvers/sph/walls/balanced_ghosts.hpp"

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
/// by pressure and the terms listed besides; only those that are asked for.
template <class Kernel, bool of_density, bool of_velocity, class Packed, class Terms, class PartsOfMethod>
void sum_rates(Neighbourhood<Packed>& near, const Terms& terms, const PartsOfMethod& parts, double h) {
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
          if constexpr (ReadsSurroundings<decltype(PartsOfMethod::pressure)>)
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

/// What a part reads of the surroundings decides what has to be found and kept of them.
template <class PartsOfMethod>
inline constexpr bool corrects =
    ReadsSurroundings<decltype(PartsOfMethod::gradient)> || ReadsSurroundings<decltype(PartsOfMethod::pressure)>;
template <class PartsOfMethod>
inline constexpr bool diffuses_rise = ReadsSurroundings<decltype(PartsOfMethod::diffusion)>;
template <class PartsOfMethod>
inline constexpr bool shifts = is_present<decltype(PartsOfMethod::shifting)>;
template <class Real, class PartsOfMethod>
using PackedOfSurface =
    std::conditional_t<corrects<PartsOfMethod> || diffuses_rise<PartsOfMethod> || shifts<PartsOfMethod>,
                       Surroundings<Real>, Packed<Real>>;

/// Continuity density, fixed wall particles that balance the fluid (Adami, Hu & Adams 2012), kick-drift-kick.
template <class Kernel, class Integrator, class Real, class FluidLaw, class Force, class Terms, class PartsOfMethod>
class FreeSurface : public Simulation<FreeSurface<Kernel, Integrator, Real, FluidLaw, Force, Terms, PartsOfMethod>,
                                      Kernel, Integrator, PackedOfSurface<Real, PartsOfMethod>, FluidLaw, Force> {
  using Base = Simulation<FreeSurface, Kernel, Integrator, PackedOfSurface<Real, PartsOfMethod>, FluidLaw, Force>;
  using Base::near_, Base::scene_, Base::smoothing_length;

 public:
  FreeSurface(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms,
              const PartsOfMethod& parts)
      : Base(scene, settings, 0), terms_(terms), parts_(parts) {}

  /// The particles are shifted, then one step of the integrator. `lap` is called at the end of each sub-step.
  template <class Laps = NoLaps>
  void step(const Laps& lap = {}) {
    shift(lap);
    this->list_neighbours(lap);
    this->advance(lap);
    this->tick();
  }

 private:
  friend Base;

  /// Rates of velocity and density, in one pass over the pairs.
  template <bool of_density, bool of_velocity, class Laps>
  void find(double time, const Laps& lap) {
    constexpr bool finds_rise = of_density && diffuses_rise<PartsOfMethod>;
    see_all<corrects<PartsOfMethod> || finds_rise>(time, lap);
    if constexpr (finds_rise) carry_rise_to_ghosts<Kernel>(near_, smoothing_length());
    sum_rates<Kernel, of_density, of_velocity>(near_, terms_, parts_, smoothing_length());
    lap(SubStep::pairs);
    if constexpr (of_velocity)
      this->add_body_force(time, lap);
    else
      lap(SubStep::rates);
  }

  /// Fluid, ghosts and images as the last motion left them, and their surroundings if they are needed.
  template <bool surroundings, class Laps>
  void see_all(double time, const Laps& lap) {
    near_.see_fluid(scene_.fluid);
    lap(SubStep::rates);
    balance_ghosts<Kernel>(near_, scene_.walls, smoothing_length(), scene_.fluid, scene_.body_force, time);
    lap(SubStep::boundaries);
    if constexpr (surroundings) find_surroundings<Kernel>(near_, smoothing_length());
    lap(SubStep::pairs);
  }

  template <class Laps>
  void shift(const Laps& lap) {
    if constexpr (shifts<PartsOfMethod>) {
      see_all<true>(this->time(), lap);
      parts_.shifting.template shift<Kernel>(near_, smoothing_length(), this->settings_.spacing, this->time_step());
      lap(SubStep::motion);
    }
  }

  Terms terms_;
  PartsOfMethod parts_;
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
