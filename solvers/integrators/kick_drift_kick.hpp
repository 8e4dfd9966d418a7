#pragma once
#include "solvers/fluid_state.hpp"
#include "solvers/laps.hpp"
#include "solvers/threads.hpp"

namespace touchstone {

/// Half a kick, all of the drift, density by the velocity that drifted, half a kick (Adami, Hu & Adams 2013, section
/// 2.4). Two passes over the pairs a step, each for a part of the rates. Undamped oscillations neither grow nor fade
/// up to a phase of 2 a step.
class KickDriftKick {
 public:
  static constexpr std::size_t past_fields = 0;

  template <class Flow, class Laps>
  void step(Flow& flow, double time, double dt, const Laps& lap) {
    if (!started_) flow.find_accelerations(time, lap);
    started_ = true;
    kick_and_drift(flow, dt);
    lap(SubStep::motion);
    flow.find_density_rate(time + dt, lap);
    thicken(flow, dt);
    lap(SubStep::motion);
    flow.find_accelerations(time + dt, lap);
    kick(flow, dt / 2);
    lap(SubStep::motion);
  }

 private:
  template <class Flow>
  static void kick_and_drift(Flow& flow, double dt) {
    FluidState& all = flow.state();
    share_out(flow.threads(), all.fluid, [&](Index begin, Index end) {
      const auto part = Eigen::seqN(begin, end - begin);
      all.vx(part) += dt / 2 * all.ax(part);
      all.vy(part) += dt / 2 * all.ay(part);
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

  bool started_ = false;
};

}  // namespace touchstone
