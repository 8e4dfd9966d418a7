#pragma once
#include "solvers/fluid_state.hpp"
#include "solvers/laps.hpp"
#include "solvers/threads.hpp"

namespace touchstone {

/// Position Verlet: half a drift, all of the kick, half a drift (Tuckerman, Berne & Martyna, J. Chem. Phys. 97 (1992),
/// 1990-2001), with density changed along with the drifts. `KickDriftKick` is velocity Verlet. Three passes over the
/// pairs a step, each for a part of the rates; a force that depends on velocity takes that of the start and is of first
/// order in the step. Undamped oscillations neither grow nor fade up to a phase of 2 a step.
class DriftKickDrift {
 public:
  static constexpr std::size_t past_fields = 0;

  template <class Flow, class Laps>
  void step(Flow& flow, double time, double dt, const Laps& lap) {
    drift(flow, dt / 2);
    lap(SubStep::motion);
    flow.find_density_rate(time + dt / 2, lap);
    thicken(flow, dt / 2);
    lap(SubStep::motion);
    flow.find_accelerations(time + dt / 2, lap);
    kick(flow, dt);
    lap(SubStep::motion);
    flow.find_density_rate(time + dt / 2, lap);
    thicken(flow, dt / 2);
    drift(flow, dt / 2);
    lap(SubStep::motion);
  }

 private:
  template <class Flow>
  static void drift(Flow& flow, double dt) {
    FluidState& all = flow.state();
    share_out(flow.threads(), all.fluid, [&](Index begin, Index end) {
      const auto part = Eigen::seqN(begin, end - begin);
      all.x(part) += dt * all.vx(part);
      all.y(part) += dt * all.vy(part);
    });
  }
  template <class Flow>
  static void thicken(Flow& flow, double dt) {
    FluidState& all = flow.state();
    share_out(flow.threads(), all.fluid, [&](Index begin, Index end) {
      const auto part = Eigen::seqN(begin, end - begin);
      all.rho(part) += dt * all.drho(part);
    });
  }
  template <class Flow>
  static void kick(Flow& flow, double dt) {
    FluidState& all = flow.state();
    share_out(flow.threads(), all.fluid, [&](Index begin, Index end) {
      const auto part = Eigen::seqN(begin, end - begin);
      all.vx(part) += dt * all.ax(part);
      all.vy(part) += dt * all.ay(part);
    });
  }
};

}  // namespace touchstone
