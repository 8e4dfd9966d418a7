#pragma once
#include "solvers/integrators/fluid_state.hpp"
#include "solvers/stepping/laps.hpp"
#include "solvers/threads.hpp"

namespace touchstone {

/// Half a kick, all of the drift, density by the velocity that drifted, half a kick (Adami, Hu & Adams 2013, section
/// 2.4). Two passes over the pairs a step, each for a part of the rates. Undamped oscillations neither grow nor fade
/// up to a phase of 2 a step.
class KickDriftKick {
 public:
  static constexpr std::size_t past_fields = 0;

  template <class Flow>
  void step(Flow& flow, double time, double dt, const Laps& lap) {
    FluidState& all = flow.state();
    const int threads = flow.threads();
    if (!started_) flow.find_rates(time, lap);
    started_ = true;
    kick(all, threads, dt / 2);
    if constexpr (requires { flow.before_drift(time, dt); }) flow.before_drift(time, dt);
    drift(all, threads, dt);
    lap(SubStep::motion);
    flow.find_density_rate(time + dt, lap);
    change_density(all, threads, dt);
    lap(SubStep::motion);
    flow.find_accelerations(time + dt, lap);
    kick(all, threads, dt / 2);
    lap(SubStep::motion);
  }

 private:
  static void drift(FluidState& all, int threads, double dt) {
    share_out_fields(threads, all.fluid, [&](Index begin, Index end) {
      const auto part = Eigen::seqN(begin, end - begin);
      all.x(part) += dt * all.vx(part);
      all.y(part) += dt * all.vy(part);
    });
  }
  static void change_density(FluidState& all, int threads, double dt) {
    share_out_fields(threads, all.fluid, [&](Index begin, Index end) {
      const auto part = Eigen::seqN(begin, end - begin);
      all.rho(part) += dt * all.drho(part);
    });
  }
  static void kick(FluidState& all, int threads, double dt) {
    share_out_fields(threads, all.fluid, [&](Index begin, Index end) {
      const auto part = Eigen::seqN(begin, end - begin);
      all.vx(part) += dt * all.ax(part);
      all.vy(part) += dt * all.ay(part);
    });
  }

  bool started_ = false;
};

}  // namespace touchstone
