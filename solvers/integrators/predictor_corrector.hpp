#pragma once
#include "solvers/integrators/fluid_state.hpp"
#include "solvers/stepping/laps.hpp"
#include "solvers/threads.hpp"

namespace touchstone {

/// The midpoint rule: half a step from the start, then all of it with the rates found there; Sun et al., section 2.4.
/// Two evaluations a step. Of second order; undamped oscillations grow by z⁴ / 8 a step, z their phase in it.
///
/// An integrator moves a `flow`, which has `state()`, `threads()` and finds rates of change: `find_rates(time,
/// lap)`, or the two parts of it.
class PredictorCorrector {
 public:
  static constexpr std::size_t past_fields = 0;

  template <class Flow>
  void step(Flow& flow, double time, double dt, const Laps& lap) {
    flow.find_rates(time, lap);
    from_rates_at_start(flow, time, dt, lap);
  }
  /// The same where the rates at the start are known.
  template <class Flow>
  static void from_rates_at_start(Flow& flow, double time, double dt, const Laps& lap) {
    remember_start(flow);
    advance(flow, dt / 2);  // predict the midpoint
    lap(SubStep::motion);
    flow.find_rates(time + dt / 2, lap);
    advance(flow, dt);  // correct from the start
    lap(SubStep::motion);
  }

 private:
  template <class Flow>
  static void remember_start(Flow& flow) {
    FluidState& all = flow.state();
    FluidState::Motion& start = all.start;
    for (Scalars* field : {&start.x, &start.y, &start.vx, &start.vy, &start.rho}) field->resize(all.fluid);
    share_out_fields(flow.threads(), all.fluid, [&](Index begin, Index end) {
      const auto part = Eigen::seqN(begin, end - begin);
      start.x(part) = all.x(part);
      start.y(part) = all.y(part);
      start.vx(part) = all.vx(part);
      start.vy(part) = all.vy(part);
      start.rho(part) = all.rho(part);
    });
  }

  template <class Flow>
  static void advance(Flow& flow, double dt) {
    FluidState& all = flow.state();
    const FluidState::Motion& start = all.start;
    share_out_fields(flow.threads(), all.fluid, [&](Index begin, Index end) {
      const auto part = Eigen::seqN(begin, end - begin);
      all.x(part) = start.x(part) + dt * all.vx(part);
      all.y(part) = start.y(part) + dt * all.vy(part);
      all.vx(part) = start.vx(part) + dt * all.ax(part);
      all.vy(part) = start.vy(part) + dt * all.ay(part);
      all.rho(part) = start.rho(part) + dt * all.drho(part);
    });
  }
};

}  // namespace touchstone
