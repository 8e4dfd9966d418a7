#pragma once
#include "solvers/integrators/fluid_state.hpp"
#include "solvers/stepping/energy_budget.hpp"
#include "solvers/stepping/laps.hpp"

#include <memory>

namespace touchstone::sph {

/// `KickDriftKick`, bit by bit, of a method for free surfaces with Tait's law and gravity, that keeps an energy
/// budget. Its parts are a `PartsWithBudget` of those of the method.
class KickDriftKickWithBudget {
  enum Past { viscous_x, viscous_y, diffused };

 public:
  static constexpr std::size_t past_fields = 3, records_diffusion_in = diffused;

  std::shared_ptr<EnergyBudget> budget = std::make_shared<EnergyBudget>();

  template <class Flow>
  void step(Flow& flow, double time, double dt, const Laps& lap) {
    auto& all = flow.state();
    const Energy before = energy_in(flow);
    if (started_) {
      budget->shifting += before.total() - budget->now.total();
    } else {
      find_density_rate(flow, time, lap);
      flow.find_accelerations(time, lap);
      budget->start = before;
    }
    started_ = true;
    kick(flow, dt / 2);
    const Energy kicked = energy_in(flow);
    flow.before_drift(time, dt);
    const Energy held = energy_in(flow);
    budget->walls += held.total() - kicked.total();
    all.x.head(all.fluid) += dt * all.vx;
    all.y.head(all.fluid) += dt * all.vy;
    budget->gravity += energy_in(flow).potential - held.potential;
    find_density_rate(flow, time + dt, lap);
    change_density(flow, dt);
    flow.find_accelerations(time + dt, lap);
    kick(flow, dt / 2);
    budget->now = energy_in(flow);
  }

 private:
  template <class Flow>
  static Energy energy_in(Flow& flow) {
    const auto& all = flow.state();
    const Tait& water = flow.scene().fluid;
    const auto& g = flow.scene().body_force.per_mass;
    const double elastic = all.rho.unaryExpr([&](double rho) { return elastic_energy(water, rho); }).sum();
    return {.kinetic = all.mass / 2 * (all.vx.square() + all.vy.square()).sum(),
            .potential = -all.mass * (g.x() * all.x.head(all.fluid) + g.y() * all.y.head(all.fluid)).sum(),
            .elastic = all.mass * elastic};
  }

  /// The first pass leaves the accelerations by viscosity alone.
  template <class Flow>
  static void find_density_rate(Flow& flow, double time, const Laps& lap) {
    auto& all = flow.state();
    flow.find_density_rate(time, lap);
    all.past[viscous_x] = all.ax;
    all.past[viscous_y] = all.ay;
  }

  /// Forces go the way of the mean velocity.
  template <class Flow>
  void kick(Flow& flow, double dt) {
    auto& all = flow.state();
    const Scalars x = all.vx + dt / 2 * all.ax, y = all.vy + dt / 2 * all.ay;
    const auto& g = flow.scene().body_force.per_mass;
    const auto work = [&](const auto& ax, const auto& ay) { return all.mass * dt * (ax * x + ay * y).sum(); };
    const Scalars& viscous_ax = all.past[viscous_x];
    const Scalars& viscous_ay = all.past[viscous_y];
    budget->viscosity += work(viscous_ax, viscous_ay);
    budget->gravity += all.mass * dt * (g.x() * x + g.y() * y).sum();
    budget->pressure += work(all.ax - viscous_ax - g.x(), all.ay - viscous_ay - g.y());
    all.vx += dt * all.ax;
    all.vy += dt * all.ay;
  }

  /// What diffusion does to the elastic energy is by the mean of P / rho² before and after, under compression.
  template <class Flow>
  void change_density(Flow& flow, double dt) {
    auto& all = flow.state();
    const Tait& water = flow.scene().fluid;
    const Scalars before = all.rho;
    all.rho += dt * all.drho;
    double whole = 0, by_diffusion = 0;
    for (Index i = 0; i < all.fluid; ++i) {
      const double rho = before[i], now = all.rho[i];
      whole += elastic_energy(water, now) - elastic_energy(water, rho);
      by_diffusion += dt * all.past[diffused][i] * (slope_of_energy(water, rho) + slope_of_energy(water, now)) / 2;
    }
    budget->smoothing += all.mass * by_diffusion;
    budget->pressure += all.mass * (whole - by_diffusion);
  }

  static double slope_of_energy(const Tait& water, double rho) {
    return std::max(water.pressure(rho), 0.0) / (rho * rho);
  }

  bool started_ = false;
};

/// Parts of a method that tell `KickDriftKickWithBudget` what their diffusion does.
template <class PartsOfMethod>
struct PartsWithBudget : PartsOfMethod {
  static constexpr std::size_t records_diffusion_in = KickDriftKickWithBudget::records_diffusion_in;
};

}  // namespace touchstone::sph
