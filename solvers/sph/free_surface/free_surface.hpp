#pragma once
/// Weakly compressible smoothed particle hydrodynamics for fluid with a free surface, from parts that are chosen by
/// type: how pressure pulls, what diffuses density, what corrects the gradient of the kernel, what shifts particles.
/// With `Antuono` it is delta-SPH (Antuono et al. 2010), with shifting too delta-plus-SPH (Sun et al. 2017).

#include "solvers/integrators/kick_drift_kick.hpp"
#include "solvers/sph/free_surface/none.hpp"
#include "solvers/sph/free_surface/surroundings.hpp"
#include "solvers/sph/simulation.hpp"
#include "solvers/sph/terms/pressure_sum.hpp"
#include "solvers/sph/walls/balanced_ghosts.hpp"
#include "solvers/sph/walls/contact.hpp"

namespace touchstone::sph {

/// The parts of a method for free surfaces. Pressures are added, not subtracted, where there is a surface: a sum over
/// fluid alone takes the pressure beyond as zero, and a difference takes none, so that its surface is unstable.
template <class Pressure = PressureSum, class Diffusion = NoDiffusion, class Gradient = PlainGradient,
          class Shifting = NoShifting>
struct Parts {
  Pressure pressure;
  Diffusion diffusion;
  Gradient gradient;
  Shifting shifting;

  /// Those types are deduced that are given, in this order.
  constexpr explicit Parts(Pressure p = {}, Diffusion d = {}, Gradient g = {}, Shifting s = {})
      : pressure(std::move(p)), diffusion(std::move(d)), gradient(std::move(g)), shifting(std::move(s)) {}
};

/// What the parts of a method read decides what its passes find and its particles keep.
template <class PartsOfMethod>
struct Finds {
  static constexpr bool diffusion = is_present<decltype(PartsOfMethod::diffusion)>,
                        shifting = is_present<decltype(PartsOfMethod::shifting)>,
                        correction = ReadsSurroundings<decltype(PartsOfMethod::gradient)> ||
                                     ReadsSurroundings<decltype(PartsOfMethod::pressure)>,
                        density_gradient = ReadsSurroundings<decltype(PartsOfMethod::diffusion)> || shifting,
                        surroundings = correction || density_gradient, budget = requires {
    PartsOfMethod::records_diffusion_in;
  };
  enum Carried : std::size_t {
    shift_x,
    shift_y,
    first_of_density_gradient = shifting ? 2 : 0,
    carried = first_of_density_gradient + (density_gradient ? 2 : 0)
  };
};
template <class Real, class PartsOfMethod>
using PackedOfSurface =
    std::conditional_t<Finds<PartsOfMethod>::correction, SurroundingsWithGhosts<Real>,
                       std::conditional_t<Finds<PartsOfMethod>::surroundings, Surroundings<Real>, Packed<Real>>>;

/// The first pass: all that depends on neither the new density nor the pressure. Writes the rate of density, by
/// continuity, -rho_i sum_j V_j (v_j - v_i) · grad W, and diffusion, by the gradient of density that the last second
/// pass has found; the accelerations by the terms; and surroundings.
///
/// Where the gradient is corrected, a ghost j, whose L is 1, pulls by P_i L_i + P_j: continuity takes the mean of both
/// gradients there, so that compression against a wall takes the energy that the pull gives back.
template <class Kernel, class Packed, class Terms, class PartsOfMethod>
void sum_by_motion(Neighbourhood<Packed>& near, const Terms& terms, const PartsOfMethod& parts, double h) {
  using Found = Finds<PartsOfMethod>;
  struct At {
    enum : std::size_t {
      slopes = 0,
      diffusion = slopes + (Found::correction ? 4 : 1),
      half_of_ghosts = diffusion + Found::diffusion,
      acceleration = half_of_ghosts + Found::correction,
      moments = acceleration + 2,
      weights = moments + (Found::surroundings ? 3 : 0),
      concentration_gradient = weights + Found::correction,
      count = concentration_gradient + (Found::shifting ? 2 : 0)
    };
  };
  const Slope<Kernel> slope(h);
  const double per_h = 1 / h;
  const auto of_pair = [=, mass = near.all.mass](const auto& i, const auto& j) {  // what these parts need of it
    auto ij = pair_of(i, j, mass);
    using Real = std::remove_cvref_t<decltype(ij.r)>;
    std::array<Real, At::count> sums;
    const auto acceleration = terms.on(ij, slope);
    sums[At::acceleration] = acceleration.x;
    sums[At::acceleration + 1] = acceleration.y;
    const Real per_r = ij.mass * ij.specific_volume_j * ij.slope, x = per_r * ij.x, y = per_r * ij.y;
    if constexpr (Found::correction) {
      const Real half = positive_part(Real(j.two(&Packed::l_yy)[1] - NumberIn<Real>(greatest_fluid_eigenvalue)));
      sums[At::weights] = -per_r;
      sums[At::half_of_ghosts] = -half * (ij.vx * x + ij.vy * y);
      const Real vx = ij.vx - half * ij.vx, vy = ij.vy - half * ij.vy;
      sums[At::slopes] = -vx * x;
      sums[At::slopes + 1] = -vx * y;
      sums[At::slopes + 2] = -vy * x;
      sums[At::slopes + 3] = -vy * y;
    } else {
      sums[At::slopes] = -ij.v_dot_r() * per_r;
    }
    if constexpr (Found::diffusion) sums[At::diffusion] = parts.diffusion.rate(ij, i, j);
    if constexpr (Found::surroundings) {
      sums[At::moments] = -x * ij.x;
      sums[At::moments + 1] = -x * ij.y;
      sums[At::moments + 2] = -y * ij.y;
    }
    if constexpr (Found::shifting) {
      const Real weight =
          parts.shifting.template concentration_weight<Kernel>(Real(ij.r * NumberIn<Real>(per_h)), per_h);
      sums[At::concentration_gradient] = weight * x;
      sums[At::concentration_gradient + 1] = weight * y;
    }
    return sums;
  };
  constexpr double close = 1e-3;  // of h  where W' / r is at its limit, which is 0 / 0 at r = 0 itself
  const double own_weight = -slope(close * h, 1 / (close * h));
  Particles& all = near.all;
  sum_over_neighbours<At::count>(
      near.fluid_near_fluid, near.seen, of_pair, [&](Index i, const std::array<double, At::count>& sums) {
        Packed& self = near.seen[i];
        if constexpr (Found::surroundings) {
          const double xx = sums[At::moments], xy = sums[At::moments + 1], yy = sums[At::moments + 2];
          if constexpr (Found::correction) {
            const double weights = sums[At::weights] + all.mass / all.rho[i] * own_weight;
            self.set_surroundings(xx, xy, yy, extent<Kernel>(xx + yy, weights, h));
          } else {
            self.set_surroundings(xx, xy, yy);
          }
        }
        double divergence = sums[At::slopes];
        if constexpr (Found::correction) {
          const auto slopes_of = [&](std::size_t k) { return self.corrected(sums[k], sums[k + 1]); };
          const Vec2 of_vx = slopes_of(At::slopes), of_vy = slopes_of(At::slopes + 2);
          divergence = ReadsSurroundings<decltype(PartsOfMethod::gradient)> ? of_vx.x() + of_vy.y()
                                                                            : sums[At::slopes] + sums[At::slopes + 3];
          divergence += sums[At::half_of_ghosts];
        }
        if constexpr (Found::shifting) {
          const Vec2 displacement =
              parts.shifting.displacement({sums[At::concentration_gradient], sums[At::concentration_gradient + 1]}, h);
          all.carried[Found::shift_x][i] = displacement.x();
          all.carried[Found::shift_y][i] = displacement.y();
        }
        all.drho[i] = -all.rho[i] * divergence;
        if constexpr (Found::diffusion) all.drho[i] += sums[At::diffusion];
        if constexpr (Found::diffusion && Found::budget)
          all.past[PartsOfMethod::records_diffusion_in][i] = sums[At::diffusion];
        all.ax[i] = sums[At::acceleration];
        all.ay[i] = sums[At::acceleration + 1];
      });
  if constexpr (Found::surroundings) near.images.refresh_fluid(near.all, near.seen);
}

/// The second pass: what the new density brings. Adds the accelerations by pressure; finds the gradient of density,
/// which the next first pass reads, and with it which way along a surface particles may be shifted.
template <class Kernel, class Packed, class PartsOfMethod>
void sum_by_pressure(Neighbourhood<Packed>& near, const PartsOfMethod& parts, double h) {
  using Found = Finds<PartsOfMethod>;
  struct At {
    enum : std::size_t {
      acceleration = 0,
      density_gradient = acceleration + 2,
      eigenvalue_gradient = density_gradient + (Found::density_gradient ? 2 : 0),
      count = eigenvalue_gradient + (Found::shifting ? 3 : 0)
    };
  };
  const auto of_pair = [parts, mass = near.all.mass, slope = Slope<Kernel>(h)](const auto& i, const auto& j) {
    const auto ij = pair_of(i, j, mass, slope);
    using Real = std::remove_cvref_t<decltype(ij.r)>;
    std::array<Real, At::count> sums;
    Acceleration<Real> acceleration;
    if constexpr (ReadsSurroundings<decltype(PartsOfMethod::pressure)>)
      acceleration = parts.pressure(ij, i, j);
    else
      acceleration = parts.gradient(i, j, parts.pressure(ij));
    sums[At::acceleration] = acceleration.x;
    sums[At::acceleration + 1] = acceleration.y;
    if constexpr (Found::density_gradient) {
      const Real difference = ij.mass * ij.slope * (1 - ij.rho_i * ij.specific_volume_j);  // V_j (rho_j - rho_i)
      sums[At::density_gradient] = difference * ij.x;
      sums[At::density_gradient + 1] = difference * ij.y;
    }
    if constexpr (Found::shifting) {
      const Real least_eigenvalue_i = i.two(&Packed::l_yy)[1], least_eigenvalue_j = j.two(&Packed::l_yy)[1],
                 difference = ij.mass * ij.specific_volume_j * ij.slope * (least_eigenvalue_j - least_eigenvalue_i);
      sums[At::eigenvalue_gradient] = difference * ij.x;
      sums[At::eigenvalue_gradient + 1] = difference * ij.y;
      sums[At::eigenvalue_gradient + 2] =
          -ij.slope * positive_part(Real(NumberIn<Real>(parts.shifting.surface) - least_eigenvalue_j));
    }
    return sums;
  };
  Particles& all = near.all;
  sum_over_neighbours<At::count>(
      near.fluid_near_fluid, near.seen, of_pair, [&](Index i, const std::array<double, At::count>& sums) {
        Packed& self = near.seen[i];
        all.ax[i] += sums[At::acceleration];
        all.ay[i] += sums[At::acceleration + 1];
        if constexpr (Found::density_gradient) {
          const Vec2 gradient = self.corrected(sums[At::density_gradient], sums[At::density_gradient + 1]);
          all.carried[Found::first_of_density_gradient][i] = gradient.x();
          all.carried[Found::first_of_density_gradient + 1][i] = gradient.y();
        }
        if constexpr (Found::shifting) {
          const Vec2 displacement =
              parts.shifting.along_surface({all.carried[Found::shift_x][i], all.carried[Found::shift_y][i]}, self,
                                           {sums[At::eigenvalue_gradient], sums[At::eigenvalue_gradient + 1]},
                                           sums[At::eigenvalue_gradient + 2] > 0);
          all.carried[Found::shift_x][i] = displacement.x();
          all.carried[Found::shift_y][i] = displacement.y();
        }
      });
}

/// Continuity density, fixed wall particles that balance the fluid (Adami, Hu & Adams 2012), kick-drift-kick.
template <class Kernel, class Integrator, class Real, class FluidLaw, class Force, class Terms, class PartsOfMethod>
class FreeSurface : public Simulation<FreeSurface<Kernel, Integrator, Real, FluidLaw, Force, Terms, PartsOfMethod>,
                                      Kernel, Integrator, PackedOfSurface<Real, PartsOfMethod>, FluidLaw, Force> {
  using Base = Simulation<FreeSurface, Kernel, Integrator, PackedOfSurface<Real, PartsOfMethod>, FluidLaw, Force>;
  using Base::near_, Base::scene_, Base::smoothing_length;
  using Found = Finds<PartsOfMethod>;

 public:
  FreeSurface(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms,
              const PartsOfMethod& parts)
      : Base(scene, settings, Found::carried, reach_of<Kernel>(settings),
             lay_out_ghosts_and_gates(scene.domain, scene.walls, settings.spacing, ghost_layers<Kernel>(settings))),
        terms_(terms),
        parts_(parts) {}

  /// What contact with walls has taken from the fluid so far.
  const Contacts& contacts() const { return contacts_; }

 private:
  friend Base;

  /// Rates of density, and of velocity with the pressure that the density has by then. Diffusion reads the gradient
  /// of density of the last second pass: kick-drift-kick begins with both, other integrators begin with none.
  template <bool of_density, bool of_velocity>
  void find(double time, const Laps& lap) {
    if constexpr (of_density) {
      see_all(time, lap);
      if constexpr (Found::density_gradient)
        see_density_gradient<Kernel>(near_, Found::first_of_density_gradient, smoothing_length());
      lap(SubStep::boundaries);
      sum_by_motion<Kernel>(near_, terms_, parts_, smoothing_length());
      lap(SubStep::pairs);
    }
    if constexpr (of_velocity) {
      if constexpr (!of_density && (Found::correction || Found::shifting)) relieve_drops();
      if constexpr (!of_density) see_all(time, lap);
      sum_by_pressure<Kernel>(near_, parts_, smoothing_length());
      lap(SubStep::pairs);
      this->add_body_force(time, lap);
    }
  }

  /// Holds what the integrator would carry into a wall. A wall does not pull: what tension draws to it loses that
  /// tension, which contact would keep up for ever.
  void meet_walls(double time, double dt) {
    Particles& all = near_.all;
    keep_off_walls(all, all.vx, all.vy, scene_.walls, contact_distance * this->spacing(), time, dt,
                   [&](Index i, const Vec2& normal, double before, double after) {
                     contacts_.add(all.mass, normal, before, after);
                     all.rho[i] = std::max(all.rho[i], scene_.fluid.density);
                   });
  }

  /// Drops of a few particles and tips bear no tension: it binds those that shifting has brought together, and they
  /// whirl ever faster; corrected gradients, up to 2.5 times those of the kernel, tear drops apart by it.
  void relieve_drops() {
    constexpr double least_under_tension = 0.4;  // a straight surface has 0.5
    Particles& all = near_.all;
    share_out_fields(this->threads(), all.fluid, [&](Index begin, Index end) {
      for (Index i = begin; i < end; ++i)
        if (near_.seen[i].least_eigenvalue < least_under_tension)
          all.rho[i] = std::max(all.rho[i], scene_.fluid.density);
    });
  }

  /// Fluid, ghosts and images as the last motion left them.
  void see_all(double time, const Laps& lap) {
    near_.see_fluid(scene_.fluid);
    lap(SubStep::rates);
    near_.move_gates(time);
    balance_ghosts<Kernel>(near_, scene_.walls, smoothing_length(), scene_.fluid, scene_.body_force, time);
    lap(SubStep::boundaries);
  }

  /// Shifting. Velocities and densities stay with their particles: it makes neither momentum nor kinetic energy.
  void spread_particles() {
    if constexpr (Found::shifting) {
      Particles& all = near_.all;
      const double fastest = std::sqrt((all.vx.square() + all.vy.square()).maxCoeff());
      const double times = fastest * this->time_step();
      keep_off_walls(all, all.carried[Found::shift_x], all.carried[Found::shift_y], scene_.walls,
                     contact_distance * this->spacing(), this->time(), times,
                     [](Index, const Vec2&, double, double) {});
      all.x.head(all.fluid) += times * all.carried[Found::shift_x];
      all.y.head(all.fluid) += times * all.carried[Found::shift_y];
    }
  }

  Terms terms_;
  PartsOfMethod parts_;
  Contacts contacts_;
};

/// sph::free_surface<sph::WendlandC2>(scene, {.spacing = ...}, sph::momentum(sph::ArtificialViscosity{...}),
/// sph::Parts(sph::PressureSum{}, sph::Antuono{...})), sums in `Real`.
template <class Kernel, class Integrator = KickDriftKick, class Real = double, class FluidLaw, class Force, class Terms,
          class PartsOfMethod>
auto free_surface(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms,
                  const PartsOfMethod& parts) {
  return FreeSurface<Kernel, Integrator, Real, FluidLaw, Force, Terms, PartsOfMethod>(scene, settings, terms, parts);
}

}  // namespace touchstone::sph
