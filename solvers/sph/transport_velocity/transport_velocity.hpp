#pragma once
/// Smoothed particle hydrodynamics with a transport velocity (Adami, Hu & Adams 2013): a background pressure moves the
/// particles, not the momentum, and keeps them evenly spread for any length of time. For fluid without a free surface.

#include "solvers/integrators/kick_drift_kick.hpp"
#include "solvers/sph/simulation.hpp"
#include "solvers/sph/without.hpp"

namespace touchstone::sph {

/// What a pair reads more: of the drift, the transport velocity less the velocity.
template <class Number>
struct PackedWithDrift : Packed<Number> {
  Number mx, my;  // kg/m² s  density times drift
};
template <class Real, class Left>
using PackedOfTransport =
    std::conditional_t<Left::template keeps<BackgroundPressure> && Left::template keeps<DriftMomentum>,
                       PackedWithDrift<Real>, Packed<Real>>;

/// Half the mean of A = rho v (transport velocity - v) along grad W (Adami, Hu & Adams 2013, (8)).
template <class Lane, class I, class J>
Acceleration<Lane> drift_momentum(const Pair<Lane>& ij, const I& i, const J& j, const Lane& volumes) {
  using Seen = std::remove_cvref_t<decltype(*i.all)>;
  const auto m_i = i.two(&Seen::mx), m_j = j.two(&Seen::mx), v_i = i.two(&Seen::vx), v_j = j.two(&Seen::vx);
  const Lane out_i = m_i[0] * ij.x + m_i[1] * ij.y, out_j = m_j[0] * ij.x + m_j[1] * ij.y,
             c = NumberIn<Lane>(0.5) * volumes;
  return {c * (v_i[0] * out_i + v_j[0] * out_j), c * (v_i[1] * out_i + v_j[1] * out_j)};
}

/// As `find_rates_by`, with what the drift of particles carries of momentum, and the drift [m/s] that an acceleration
/// by a background pressure [Pa], -(p_b / m) sum_j (V_i² + V_j²) grad W, makes in half a step [s]: it spreads the
/// particles.
template <class Kernel, bool of_density, bool drift_has_momentum, class Packed, class Terms>
void find_rates_and_drift_by(const Terms& terms_of_method, Neighbourhood<Packed>& near, double h,
                             double background_pressure, double half_step) {
  Particles& all = near.all;
  sum_over_neighbours<5>(
      near.fluid_near_fluid, near.seen,
      [terms = terms_of_method, mass = all.mass, slope = Slope<Kernel>(h),
       background = static_cast<typename Packed::Number>(background_pressure)](const auto& i, const auto& j) {
        auto ij = pair_of(i, j, mass);
        auto acceleration = terms.on(ij, slope);
        const auto thicker = ij.continuity();
        const auto volumes =
            ij.mass * ij.slope *
            (ij.specific_volume_i * ij.specific_volume_i + ij.specific_volume_j * ij.specific_volume_j);
        if constexpr (drift_has_momentum) acceleration += drift_momentum(ij, i, j, volumes);
        return std::array{thicker, acceleration.x, acceleration.y, -background * volumes * ij.x,
                          -background * volumes * ij.y};
      },
      [drho = all.drho.data(), ax = all.ax.data(), ay = all.ay.data(), drift_x = all.carried[0].data(),
       drift_y = all.carried[1].data(), half_step](Index i, const std::array<double, 5>& sums) {
        if constexpr (of_density) drho[i] = sums[0];
        ax[i] = sums[1];
        ay[i] = sums[2];
        drift_x[i] = half_step * sums[3];
        drift_y[i] = half_step * sums[4];
      });
}

/// Density by continuity, kick-drift-kick, walls by ghosts with mirrored velocity (Adami, Hu & Adams 2012).
///
/// Adami, Hu & Adams sum the density anew each step and let the mean pressure of a pair act. In a channel both make the
/// lattice of particles elastic: a uniform pressure p resists its shear with a modulus of about 0.003 p, which bends
/// the straight profile of Couette flow by 2.1 % at 1 s. With continuity and `PressureDifference` it is 0.01 %.
template <class Kernel, class Integrator, class Real, class Left, class FluidLaw, class Force, class Terms>
class TransportVelocity : public Simulation<TransportVelocity<Kernel, Integrator, Real, Left, FluidLaw, Force, Terms>,
                                            Kernel, Integrator, PackedOfTransport<Real, Left>, FluidLaw, Force> {
  using Seen = PackedOfTransport<Real, Left>;
  using Base = Simulation<TransportVelocity, Kernel, Integrator, Seen, FluidLaw, Force>;
  using Base::near_, Base::scene_;

 public:
  using Base::steps, Base::time_step;

  TransportVelocity(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms)
      : Base(scene, settings, has_background ? 2 : 0), terms_(terms) {}

 private:
  friend Base;

  static constexpr long steps_between_corrections = 30;
  static constexpr double background_fraction = 0.1;  // of rho0 c²; more disturbs the flow, less is enough too
  static constexpr bool has_background = Left::template keeps<BackgroundPressure>;
  static constexpr bool drift_has_momentum = has_background && Left::template keeps<DriftMomentum>;

  // Carried with the particles: transport velocity less velocity [m/s].
  Scalars& wx() { return near_.all.carried[0]; }
  Scalars& wy() { return near_.all.carried[1]; }

  void spread_particles() {
    if constexpr (has_background) {
      near_.all.x.head(near_.all.fluid) += time_step() * wx();
      near_.all.y.head(near_.all.fluid) += time_step() * wy();
    }
  }

  /// The fluid fills its domain, so the particles' volumes add up to what they were at the start. Continuity alone lets
  /// their sum creep, by 0.07 % in 10 s of Poiseuille flow, and with it the viscosity.
  void correct_density() {
    if constexpr (Left::template keeps<VolumeConstraint>) {
      if (steps() % steps_between_corrections != 0) return;
      Scalars& rho = near_.all.rho;
      rho *= scene_.fluid.density / static_cast<double>(near_.all.fluid) * rho.inverse().sum();
    }
  }

  /// Rates of velocity and density, in one pass over the pairs.
  template <bool of_density, bool of_velocity>
  void find(double time, const Laps& lap) {
    if constexpr (drift_has_momentum) see_drift();
    this->see_fluid_and_ghosts(time, lap);
    if constexpr (of_velocity && has_background)
      find_rates_and_drift<of_density>();
    else if constexpr (of_velocity)
      find_rates_by<Kernel, of_density>(terms_, near_, this->smoothing_length());
    else
      find_continuity<Kernel>(near_, this->smoothing_length());
    lap(SubStep::pairs);
    if constexpr (of_velocity) this->add_body_force(time, lap);
  }

  template <bool of_density>
  void find_rates_and_drift() {
    const double c = scene_.fluid.sound_speed();
    find_rates_and_drift_by<Kernel, of_density, drift_has_momentum>(
        terms_, near_, this->smoothing_length(), background_fraction * scene_.fluid.density * c * c, time_step() / 2);
  }

  void see_drift() {
    share_out_fields(this->threads(), near_.all.fluid, [&](Index begin, Index end) {
      const double *const rho = near_.all.rho.data(), *const drift_x = wx().data(), *const drift_y = wy().data();
      Seen* const seen = near_.seen.data();
      for (Index i = begin; i < end; ++i) {
        seen[i].mx = static_cast<Real>(rho[i] * drift_x[i]);
        seen[i].my = static_cast<Real>(rho[i] * drift_y[i]);
      }
    });
  }

  Terms terms_;
};

/// sph::transport_velocity<sph::QuinticSpline>(scene, {.spacing = ...}, sph::momentum(sph::PressureDifference{}, ...)),
/// sums in `Real`.
template <class Kernel, class Integrator = KickDriftKick, class Real = double, class Left = Without<>, class FluidLaw,
          class Force, class Terms>
auto transport_velocity(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms) {
  return TransportVelocity<Kernel, Integrator, Real, Left, FluidLaw, Force, Terms>(scene, settings, terms);
}

}  // namespace touchstone::sph
