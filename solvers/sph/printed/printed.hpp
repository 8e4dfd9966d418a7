#pragma once
/// Smoothed particle hydrodynamics as printed by Sun et al., sections 2.2 to 2.5.

#include "solvers/sph/neighbourhood.hpp"
#include "solvers/sph/simulation.hpp"
#include "solvers/sph/walls/repulsion.hpp"
#include "solvers/sph/without.hpp"

namespace touchstone::sph {

/// Density reinitialised from the mass around, with the kernel normalised over the particles that are there (29), (30):
/// rho_i = sum_j m_j W_ij / sum_j (m_j / rho_j) W_ij, the particle itself included.
template <class Kernel, class Packed>
void reinitialise_density(Neighbourhood<Packed>& near, double h) {
  Scalars& rho = near.all.rho;
  sum_over_neighbours<2>(
      near.fluid_near_fluid, near.seen,
      [per_h = static_cast<typename Packed::Number>(1 / h)](const auto& i, const auto& j) {
        const auto r = distance(i, j);
        using Real = std::remove_cvref_t<decltype(r)>;
        const Real w = Kernel::w(Real(r * per_h));
        return std::array<Real, 2>{w, w * j.two(&Packed::specific_volume)[0]};
      },
      [&](Index i, const std::array<double, 2>& sums) {
        rho[i] = (sums[0] + Kernel::w(0.0)) / (sums[1] + Kernel::w(0.0) / rho[i]);
      });
}

/// Continuity density, predictor-corrector, density reinitialised every 30 steps, ghosts and soft repulsion at walls.
template <class Kernel, class Integrator, class Real, class Left, class FluidLaw, class Force, class Terms>
class Printed : public Simulation<Printed<Kernel, Integrator, Real, Left, FluidLaw, Force, Terms>, Kernel, Integrator,
                                  Packed<Real>, FluidLaw, Force> {
  using Base = Simulation<Printed, Kernel, Integrator, Packed<Real>, FluidLaw, Force>;
  using Base::near_, Base::scene_, Base::settings_;

 public:
  using Base::steps;

  Printed(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms)
      : Base(scene, settings, 0, reach_of<Kernel>(settings, repels ? SoftRepulsion<0>::reach(settings.spacing) : 0, 5),
             lay_out_ghosts_and_walls(scene.domain, scene.walls, settings.spacing, ghost_layers<Kernel>(settings))),
        terms_(terms) {}

 private:
  friend Base;

  static constexpr long steps_between_reinitialisations = 30;
  static constexpr bool repels = Left::template keeps<Repulsion>;

  /// (29), (30)
  void correct_density() {
    if constexpr (Left::template keeps<DensityReinitialisation>) {
      if (steps() % steps_between_reinitialisations != 0) return;
      near_.see_fluid(scene_.fluid);
      reinitialise_density<Kernel>(near_, this->smoothing_length());
    }
  }

  /// Rates of velocity and density, in one pass over the pairs.
  template <bool of_density, bool of_velocity>
  void find(double time, const Laps& lap) {
    this->see_fluid_and_ghosts(time, lap);
    if constexpr (of_velocity)
      find_rates_by<Kernel, of_density>(terms_, near_, this->smoothing_length());
    else
      find_continuity<Kernel>(near_, this->smoothing_length());
    lap(SubStep::pairs);
    if constexpr (of_velocity) {
      push_off_walls(lap);
      this->add_body_force(time, lap);
    }
  }

  void push_off_walls(const Laps& lap) {
    if constexpr (repels) {
      push_off<0>(near_, scene_.fluid.sound_speed(), settings_.spacing);
      push_off<1>(near_, scene_.fluid.sound_speed(), settings_.spacing);
      lap(SubStep::boundaries);
    }
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
