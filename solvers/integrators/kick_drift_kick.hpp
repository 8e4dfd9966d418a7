#pragma once
#include "solvers/integrators/fluid_state.hpp"
#include "solvers/stepping/laps.hpp"
#include "solvers/threads.hpp"

#include <initializer_list>

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
    add(all, threads, dt / 2, {{&all.vx, &all.ax}, {&all.vy, &all.ay}});
    if constexpr (requires { flow.before_drift(time, dt); }) flow.before_drift(time, dt);
    add(all, threads, dt, {{&all.x, &all.vx}, {&all.y, &all.vy}});
    lap(SubStep::motion);
    flow.find_density_rate(time + dt, lap);
    add(all, threads, dt, {{&all.rho, &all.drho}});
    lap(SubStep::motion);
    flow.find_accelerations(time + dt, lap);
    add(all, threads, dt / 2, {{&all.vx, &all.ax}, {&all.vy, &all.ay}});
    lap(SubStep::motion);
  }

 private:
  struct Change {
    Scalars* field;
    const Scalars* rate;
  };
  static void add(const FluidState& all, int threads, double dt, std::initializer_list<Change> changes) {
    share_out_fields(threads, all.fluid, [&](Index begin, Index end) {
      const auto part = Eigen::seqN(begin, end - begin);
      for (const auto& [field, rate] : changes) (*field)(part) += dt * (*rate)(part);
    });
  }

  bool started_ = false;
};

}  // namespace touchstone
