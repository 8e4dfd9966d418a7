#pragma once
/// Smoothed particle hydrodynamics with a transport velocity (Adami, Hu & Adams 2013): a background pressure moves the
/// particles, not the momentum, and keeps them evenly spread for any length of time. For fluid without a free surface.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/sph/momentum.hpp"
#include "solvers/sph/neighbourhood.hpp"
#include "solvers/sph/settings.hpp"
#include "solvers/sph/smoothing.hpp"

namespace touchstone::sph {

/// Density by continuity, kick-drift-kick, walls by ghosts with mirrored velocity (Adami, Hu & Adams 2012).
///
/// Adami, Hu & Adams sum the density anew each step and let the mean pressure of a pair act. In a channel both make the
/// lattice of particles elastic: a uniform pressure p resists its shear with a modulus of about 0.003 p, which bends
/// the straight profile of Couette flow by 2.1 % at 1 s. With continuity and `PressureDifference` it is 0.01 %.
template <class Kernel, class FluidLaw, class Force, class Terms>
class TransportVelocity {
 public:
  TransportVelocity(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms)
      : scene_(scene),
        settings_(checked(settings)),
        terms_(terms),
        near_(scene.domain, scene.filled, scene.fluid.density, settings.spacing,
              Kernel::support * settings.smoothing_length, skin * settings.spacing,
              lay_out_ghosts(scene.domain, scene.walls, settings.spacing, ghost_layers<Kernel>(settings)), 4) {
    for (Scalars* field : {&spread_x_, &spread_y_, &density_rate_}) field->setZero(near_.all.fluid);
    for (Scalars& sum : ghost_sums_) sum.setZero(near_.ghosts());
    find_accelerations(0);
  }

  /// One kick-drift-kick step (Adami, Hu & Adams 2013, section 2.4).
  void step() {
    near_.follow(steps_, time_, time_step());
    kick(time_step() / 2);
    drift(time_step());
    const double end = time_ + time_step();
    advance_density(time_step(), end);
    find_accelerations(end);
    kick(time_step() / 2);
    if (++steps_ % 30 == 0) keep_volume();
    time_ = static_cast<double>(steps_) * time_step();
  }

  double time() const { return time_; }                     // s
  double time_step() const { return settings_.time_step; }  // s
  long steps() const { return steps_; }
  Index particles() const { return near_.all.fluid; }
  Index boundary_particles() const { return near_.ghosts(); }
  /// Throws Diverged when a particle is outside the domain.
  Samples samples() const {
    near_.refuse_strays(steps_, time_);
    return near_.samples(time_, scene_.fluid);
  }

 private:
  static constexpr double skin = 0.2;              // spacings
  static constexpr double background_share = 0.1;  // of rho0 c²; more disturbs the flow, less is enough too

  // Carried with the particles: acceleration [m/s²], and transport velocity less velocity [m/s].
  Scalars& ax() { return near_.all.carried[0]; }
  Scalars& ay() { return near_.all.carried[1]; }
  Scalars& wx() { return near_.all.carried[2]; }
  Scalars& wy() { return near_.all.carried[3]; }

  void kick(double dt) {
    Particles& all = near_.all;
    all.vx.head(all.fluid) += dt * ax().head(all.fluid);
    all.vy.head(all.fluid) += dt * ay().head(all.fluid);
  }

  void drift(double dt) {
    Particles& all = near_.all;
    all.x.head(all.fluid) += dt * (all.vx + wx()).head(all.fluid);
    all.y.head(all.fluid) += dt * (all.vy + wy()).head(all.fluid);
  }

  /// Fluid, ghosts and images as the last motion left them.
  void update_surroundings(double time) {
    Particles& all = near_.all;
    for (Index i = 0; i < all.fluid; ++i) all.p[i] = scene_.fluid.pressure(all.rho[i]);  // (33)
    near_.images.refresh_fluid(all);
    fill_ghosts<Kernel>(all, near_.fluid_near_ghost, near_.boundary.ghosts, scene_.walls, settings_.smoothing_length,
                        scene_.fluid.density, time, ghost_sums_);
    near_.images.refresh_boundary(all);
  }

  /// Continuity (23) over `dt` [s], with the velocity that moved the particles.
  void advance_density(double dt, double time) {
    Particles& all = near_.all;
    update_surroundings(time);
    sum_over_neighbours<1>(near_.fluid_near_fluid, {density_rate_.data()}, [&](Block i, Row j) -> std::array<Lanes, 1> {
      const Pair<Lanes> ij = pair_of<Kernel>(all, i, j, settings_.smoothing_length);
      return {ij.mass * ij.slope * ij.approach()};
    });
    all.rho.head(all.fluid) += dt * density_rate_;
  }

  /// The fluid fills its domain, so the particles' volumes add up to what they were at the start. Continuity alone lets
  /// their sum creep, by 0.07 % in 10 s of Poiseuille flow, and with it the viscosity.
  void keep_volume() {
    auto rho = near_.all.rho.head(near_.all.fluid);
    rho *= scene_.fluid.density / static_cast<double>(near_.all.fluid) * rho.inverse().sum();
  }

  void find_accelerations(double time) {
    Particles& all = near_.all;
    update_surroundings(time);
    sum_pairs();
    if constexpr (is_present<Force>) add_force(scene_.body_force, all, time, ax(), ay());
    wx().head(all.fluid) = time_step() / 2 * spread_x_;
    wy().head(all.fluid) = time_step() / 2 * spread_y_;
  }

  /// The listed terms of the momentum equation, what the drift of particles carries of momentum, and the acceleration
  /// by a background pressure, -(p_b / m) sum_j (V_i² + V_j²) grad W, which spreads the particles.
  void sum_pairs() {
    const Particles& all = near_.all;
    const double c = scene_.fluid.sound_speed(), background = background_share * scene_.fluid.density * c * c,
                 h = settings_.smoothing_length;
    sum_over_neighbours<4>(near_.fluid_near_fluid, {ax().data(), ay().data(), spread_x_.data(), spread_y_.data()},
                           [&](Block i, Row j) -> std::array<Lanes, 4> {
                             const Pair<Lanes> ij = pair_of<Kernel>(all, i, j, h);
                             const Pull<Lanes> pull = terms_(ij), carried = momentum_of_drift(ij, i, j);
                             const Lanes spread = -background * ij.mass * volumes_squared(ij) * ij.slope;
                             return {pull.x + carried.x, pull.y + carried.y, spread * ij.x, spread * ij.y};
                           });
  }

  /// (V_i² + V_j²) / m².
  static Lanes volumes_squared(const Pair<Lanes>& ij) { return 1 / (ij.rho_i * ij.rho_i) + 1 / (ij.rho_j * ij.rho_j); }

  /// Half the mean of A = rho v (transport velocity - v) along grad W (Adami, Hu & Adams 2013, (8)).
  Pull<Lanes> momentum_of_drift(const Pair<Lanes>& ij, Block i, Row j) {
    const Particles& all = near_.all;
    const Lanes out_i = ij.rho_i * (i(wx()) * ij.x + i(wy()) * ij.y),
                out_j = ij.rho_j * (j(wx()) * ij.x + j(wy()) * ij.y);
    const Lanes c = 0.5 * ij.mass * volumes_squared(ij) * ij.slope;
    return {c * (i(all.vx) * out_i + j(all.vx) * out_j), c * (i(all.vy) * out_i + j(all.vy) * out_j)};
  }

  Scene<FluidLaw, Force> scene_;
  Settings settings_;
  Terms terms_;
  Neighbourhood near_;
  Scalars spread_x_, spread_y_;  // m/s²
  Scalars density_rate_;         // kg/m³ s
  std::array<Scalars, 5> ghost_sums_;
  double time_ = 0;
  long steps_ = 0;
};

/// sph::transport_velocity<sph::QuinticSpline>(scene, {.spacing = ...}, sph::momentum(sph::PressureDifference{}, ...))
template <class Kernel, class FluidLaw, class Force, class Terms>
auto transport_velocity(const Scene<FluidLaw, Force>& scene, const Settings& settings, const Terms& terms) {
  return TransportVelocity<Kernel, FluidLaw, Force, Terms>(scene, settings, terms);
}

}  // namespace touchstone::sph
