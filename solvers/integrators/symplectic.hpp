#pragma once
#include "solvers/integrators/fluid_state.hpp"
#include "solvers/stepping/laps.hpp"
#include "solvers/threads.hpp"

#include <array>

namespace touchstone {

/// The symplectic scheme of DualSPHysics (Domínguez et al., Comput. Part. Mech. 9 (2022), 867-895): half a step from
/// the start, then velocity by the rates found there, places by the mean of the old and the new velocity, and density
/// by rho (2 - e) / (2 + e) with e = -dt drho / rho there. Two evaluations a step.
///
/// Symplectic for forces that depend on places alone; in a weakly compressible fluid they depend on density, and sound
/// grows by z⁴ / 8 a step, z its phase in it, as with `PredictorCorrector`: only a `DriftKickDrift` keeps it.
class Symplectic {
 public:
  static constexpr std::size_t past_fields = 0;

  template <class Flow, class Laps>
  void step(Flow& flow, double time, double dt, const Laps& lap) {
    flow.find_rates(time, lap);
    predict(flow, dt / 2);
    lap(SubStep::motion);
    flow.find_rates(time + dt / 2, lap);
    correct(flow, dt);
    lap(SubStep::motion);
  }

 private:
  template <class Flow>
  void predict(Flow& flow, double dt) {
    FluidState& all = flow.state();
    for (Scalars& field : start_) field.resize(all.fluid);
    share_out_fields(flow.threads(), all.fluid, [&](Index begin, Index end) {
      const auto part = Eigen::seqN(begin, end - begin);
      start_[0](part) = all.vx(part);
      start_[1](part) = all.vy(part);
      start_[2](part) = all.rho(part);
      all.x(part) += dt * all.vx(part);
      all.y(part) += dt * all.vy(part);
      all.vx(part) += dt * all.ax(part);
      all.vy(part) += dt * all.ay(part);
      all.rho(part) += dt * all.drho(part);
    });
  }

  /// Places stand half a step on, by the velocity at the start.
  template <class Flow>
  void correct(Flow& flow, double dt) const {
    FluidState& all = flow.state();
    share_out_fields(flow.threads(), all.fluid, [&](Index begin, Index end) {
      const auto part = Eigen::seqN(begin, end - begin);
      all.vx(part) = start_[0](part) + dt * all.ax(part);
      all.vy(part) = start_[1](part) + dt * all.ay(part);
      all.x(part) += dt / 2 * all.vx(part);
      all.y(part) += dt / 2 * all.vy(part);
      const Scalars e = -dt * all.drho(part) / all.rho(part);
      all.rho(part) = start_[2](part) * (2 - e) / (2 + e);
    });
  }

  std::array<Scalars, 3> start_;  // vx, vy, rho
};

}  // namespace touchstone
