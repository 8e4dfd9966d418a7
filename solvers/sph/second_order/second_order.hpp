#pragma once
/// Smoothed particle hydrodynamics of second order, for fluid that fills its domain. Around each particle velocities
/// and pressure are fitted by polynomials of second degree, weighted by the kernel, and the equations of motion use
/// their derivatives (finite particle method, Liu & Liu, Appl. Numer. Math. 56 (2006), 19-36).

#include "solvers/integrators/adams_bashforth.hpp"
#include "solvers/quadratic_fit.hpp"
#include "solvers/sph/particles.hpp"
#include "solvers/sph/simulation.hpp"
#include "solvers/sph/walls/extrapolated_ghosts.hpp"
#include "solvers/threads.hpp"

namespace touchstone::sph {

/// What a particle carries from the rates to the next drift, a motion besides that of the fluid: its direction and the
/// slopes of what changes on the way.
enum DriftField { drift_x, drift_y, vx_along_x, vx_along_y, vy_along_x, vy_along_y, rho_along_x, rho_along_y };
inline constexpr std::size_t drift_fields = 8;

/// Moves particles by so many times their drift; velocity and density change as their slopes say.
inline void drift(Particles& all, double times, Index begin, Index end) {
  const auto part = Eigen::seqN(begin, end - begin);
  const Scalars x = times * all.carried[drift_x](part), y = times * all.carried[drift_y](part);
  const auto change = [&](DriftField slope_x, DriftField slope_y) {
    return x * all.carried[slope_x](part) + y * all.carried[slope_y](part);
  };
  all.x(part) += x;
  all.y(part) += y;
  all.vx(part) += change(vx_along_x, vx_along_y);
  all.vy(part) += change(vy_along_x, vy_along_y);
  all.rho(part) += change(rho_along_x, rho_along_y);
}

/// Of vx, vy and pressure.
template <class Real>
using FitOfFlow = QuadraticFit<LanesOf<Real>, 3>;

/// What a neighbour adds to the sums of a fit, in lengths h.
template <class Kernel, class Real>
struct TermsOfFit {
  Real per_h;  // 1/m

  template <class I, class J>
  auto operator()(const I& i, const J& j) const {
    const auto sides = apart(j, i);
    const LanesOf<Real> x = sides[0] * per_h, y = sides[1] * per_h;
    const LanesOf<Real> w = Kernel::w(square_root(LanesOf<Real>(x * x + y * y)));
    const auto v_i = i.two(&Packed<Real>::vx), v_j = j.two(&Packed<Real>::vx);
    const auto volume_and_p_i = i.two(&Packed<Real>::specific_volume),
               volume_and_p_j = j.two(&Packed<Real>::specific_volume);
    return FitOfFlow<Real>::terms(w, x, y, {v_j[0] - v_i[0], v_j[1] - v_i[1], volume_and_p_j[1] - volume_and_p_i[1]});
  }
};

/// Derivatives are exact for polynomials of second degree, however the particles stand. What sums over symmetric pairs
/// conserve, momentum and its moment, is conserved to the order of the method only.
///
/// Particles move with the fluid and drift besides from where they are dense, so that they stay evenly spread for any
/// length of time; on the way their velocity and density change by the slopes that the fits have found. So they do on
/// the short way back from a wall that their inertia took them too near to, as where a lid carries them into a corner.
/// What a fit leaves, of fourth order in the spacing, is damped: motion that the particles cannot resolve.
///
/// Evenly spread particles stand for equal parts of the volume that they fill, so the mean of their densities is that
/// of the fluid's mass, and is kept. Continuity at each of them alone lets it creep, and the mean pressure with it.
template <class Kernel, class Integrator, class Real, class FluidLaw, class Force>
class SecondOrder : public Simulation<SecondOrder<Kernel, Integrator, Real, FluidLaw, Force>, Kernel, Integrator,
                                      Packed<Real>, FluidLaw, Force> {
  using Base = Simulation<SecondOrder, Kernel, Integrator, Packed<Real>, FluidLaw, Force>;
  using Base::scene_, Base::settings_, Base::smoothing_length, Base::threads;

 public:
  /// Throws std::invalid_argument for settings that are not positive, or water that does not fill the domain.
  SecondOrder(const Scene<FluidLaw, Force>& scene, const Settings& settings)
      : Base(scene, settings, drift_fields), sound_speed_(scene.fluid.sound_speed()) {
    require_filled("sph", scene.filled, scene.domain.box);
    mean_density_ = near_.all.rho.mean();
  }

 protected:
  using Base::near_;

  /// Puts particles back that are too near to a wall. Mostly none is: the maximum of all tells.
  void keep_off(const Wall& wall, Index begin, Index end) {
    Particles& all = near_.all;
    Scalars& along = wall.axis == 0 ? all.x : all.y;
    const auto short_by = [&](const auto& at) {
      return least_distance * settings_.spacing - wall.inward * (at - wall.position);
    };
    if (begin == end || !(short_by(along(Eigen::seqN(begin, end - begin))).maxCoeff() > 0)) return;
    for (Index i = begin; i < end; ++i) {
      const double missing = short_by(along[i]), back = wall.inward * missing;
      if (!(missing > 0)) continue;
      const auto change = [&](DriftField slope_x, DriftField slope_y) {
        return back * all.carried[wall.axis == 0 ? slope_x : slope_y][i];
      };
      along[i] += back;
      all.vx[i] += change(vx_along_x, vx_along_y);
      all.vy[i] += change(vy_along_x, vy_along_y);
      all.rho[i] += change(rho_along_x, rho_along_y);
    }
  }

 private:
  friend Base;

  static constexpr double spreading = 1;          // of the speed of sound, where the neighbours' centre is off by h
  static constexpr double least_distance = 0.25;  // spacings from a wall; half of one at the start
  static constexpr double nearest_wall = 0.4;     // likewise, of fluid that tells ghosts its velocity as it is
  static constexpr double damping_of_rho = 0.5;   // of what a fit leaves, while sound travels a spacing
  static constexpr double damping_of_v =
      8;  // likewise, while the fluid is strained by as much as it is long; no faster

  /// What is made of a fit: rates of change, then what is carried to the next drift.
  static constexpr std::size_t rate_of_rho = 0, rate_of_vx = 1, rate_of_vy = 2, carried = 3,
                               made = carried + drift_fields;

  void spread_particles() {
    Particles& all = near_.all;
    share_out_fields(threads(), all.fluid, [&](Index begin, Index end) {
      drift(all, this->time_step(), begin, end);
      for (const Wall& wall : scene_.walls) keep_off(wall, begin, end);
    });
  }

  void correct_density() { near_.all.rho += mean_density_ - near_.all.rho.mean(); }

  template <bool of_density, bool of_velocity>
  void find(double time, const Laps& lap) {
    static_assert(of_density && of_velocity, "one fit gives both rates: the integrator has to ask for both at once");
    near_.see_fluid(scene_.fluid);
    lap(SubStep::rates);
    extrapolate_to_ghosts<Kernel>(near_, scene_.walls, smoothing_length(), nearest_wall * settings_.spacing,
                                  scene_.fluid, scene_.body_force, time);
    lap(SubStep::boundaries);
    fit_and_move();
    lap(SubStep::pairs);
    this->add_body_force(time, lap);
  }

  void fit_and_move() {
    const double of_rho = damping_of_rho * sound_speed_ / settings_.spacing;
    const double of_v = std::min(damping_of_v * strain_rate_, of_rho);
    const TermsOfFit<Kernel, Real> terms{static_cast<Real>(1 / smoothing_length())};
    const MotionOfFit motion{scene_.fluid, smoothing_length(), spreading * sound_speed_, of_rho, of_v};
    Particles& all = near_.all;
    std::array<double*, made> fields{all.drho.data(), all.ax.data(), all.ay.data()};
    for (std::size_t k = 0; k < drift_fields; ++k) fields[carried + k] = all.carried[k].data();
    sum_over_neighbours<FitOfFlow<Real>::count>(near_.fluid_near_fluid, near_.seen, terms, motion,
                                                [&](Index i, const std::array<double, made>& of_particle) {
                                                  for (std::size_t k = 0; k < made; ++k) fields[k][i] = of_particle[k];
                                                });
    strain_rate_ = 0;
    for (const DriftField slope : {vx_along_x, vx_along_y, vy_along_x, vy_along_y})
      strain_rate_ = std::max(strain_rate_, near_.all.carried[slope].abs().maxCoeff());
  }

  /// The equations of motion of a Newtonian fluid, and how particles will drift, of the sums of their fits.
  struct MotionOfFit {
    using Numbers = LanesOf<Real>;
    const FluidLaw& fluid;
    double h, spread, of_rho, of_v;  // m, m/s  from where particles are dense, 1/s, 1/s

    [[gnu::flatten]] std::array<Numbers, made> operator()(const ParticleLanes<Packed<Real>>& i,
                                                          const typename FitOfFlow<Real>::Sums& sums) const {
      enum Factor { rest, along_x, along_y, xx, xy, yy };
      const auto [vx, vy, p] = FitOfFlow<Real>::through_zero(sums);
      const Numbers rho = i.two(&Packed<Real>::rho)[0], specific_volume = i.two(&Packed<Real>::specific_volume)[0];
      const Numbers per_c2 = 1 / each_lane(rho, [&](const auto& density) { return fluid.pressure_slope(density); });
      const auto real = [](double number) { return static_cast<Real>(number); };
      const Real per_h = real(1 / h);
      std::array<Numbers, made> all;
      all[rate_of_rho] = real(of_rho) * per_c2 * p[rest] - per_h * rho * (vx[along_x] + vy[along_y]);
      all[rate_of_vx] = real(of_v) * vx[rest] - per_h * specific_volume * p[along_x];
      all[rate_of_vy] = real(of_v) * vy[rest] - per_h * specific_volume * p[along_y];
      if constexpr (Viscous<FluidLaw>) {  // a factor of x² or y² is half of a second derivative
        const Numbers nu_per_h2 = real(fluid.viscosity / (h * h)) * specific_volume;
        all[rate_of_vx] += nu_per_h2 * (2 * (vx[xx] + vx[yy]) + real(1. / 3) * (2 * vx[xx] + vy[xy]));
        all[rate_of_vy] += nu_per_h2 * (2 * (vy[xx] + vy[yy]) + real(1. / 3) * (vx[xy] + 2 * vy[yy]));
      }
      const Numbers away = real(-spread) / sums[0];
      all[carried + drift_x] = away * sums[1];
      all[carried + drift_y] = away * sums[2];
      all[carried + vx_along_x] = per_h * vx[along_x];
      all[carried + vx_along_y] = per_h * vx[along_y];
      all[carried + vy_along_x] = per_h * vy[along_x];
      all[carried + vy_along_y] = per_h * vy[along_y];
      all[carried + rho_along_x] = per_h * per_c2 * p[along_x];
      all[carried + rho_along_y] = per_h * per_c2 * p[along_y];
      return all;
    }
  };

  double sound_speed_;       // m/s
  double mean_density_ = 0;  // kg/m³
  double strain_rate_ = 0;   // 1/s  the largest slope of a velocity
};

/// sph::second_order<sph::WendlandC2>(scene, {.spacing = ..., .smoothing_length = 1.3 spacings, ...}), sums in `Real`.
template <class Kernel, class Integrator = AdamsBashforth, class Real = double, class FluidLaw, class Force>
auto second_order(const Scene<FluidLaw, Force>& scene, const Settings& settings) {
  return SecondOrder<Kernel, Integrator, Real, FluidLaw, Force>(scene, settings);
}

}  // namespace touchstone::sph
