#pragma once
#include "solvers/integrators/predictor_corrector.hpp"

namespace touchstone {

/// Third-order Adams-Bashforth for velocity and density, places by the mean of the old and the new velocity: one
/// evaluation a step. Durran, Mon. Weather Rev. 119 (1991), 702-720: oscillations are damped and stable up to a phase
/// of 0.72 a step, the most but for a few per cent that one evaluation allows. Started by two midpoint steps, and again
/// when the step changes: its weights are those of equal steps.
class AdamsBashforth {
 public:
  static constexpr std::size_t past_fields = 6;

  template <class Flow>
  void step(Flow& flow, double time, double dt, const Laps& lap) {
    flow.find_rates(time, lap);
    FluidState& all = flow.state();
    if (dt != last_dt_) known_ = 0;
    last_dt_ = dt;
    if (known_ < 2) {
      remember_rates(all);
      all.ax = all.past[0], all.ay = all.past[1], all.drho = all.past[2];
      PredictorCorrector::from_rates_at_start(flow, time, dt, lap);
      ++known_;
      return;
    }
    advance(flow, dt);
    remember_rates(all);
    lap(SubStep::motion);
  }

 private:
  template <class Flow>
  static void advance(Flow& flow, double dt) {
    FluidState& all = flow.state();
    share_out_fields(flow.threads(), all.fluid, [&](Index begin, Index end) {
      for (std::size_t k = 0; k < 2; ++k) {
        double *const x = (k == 0 ? all.x : all.y).data(), *const v = (k == 0 ? all.vx : all.vy).data();
        const double* const a = (k == 0 ? all.ax : all.ay).data();
        const double *const last = all.past[k].data(), *const before = all.past[k + 3].data();
        for (Index i = begin; i < end; ++i) {
          const double old = v[i];
          v[i] = old + dt / 12 * (23 * a[i] - 16 * last[i] + 5 * before[i]);
          x[i] += dt / 2 * (old + v[i]);
        }
      }
      const auto part = Eigen::seqN(begin, end - begin);
      all.rho(part) += dt / 12 * (23 * all.drho(part) - 16 * all.past[2](part) + 5 * all.past[5](part));
    });
  }

  /// The rates become those of the last step, and those of the last step those of the step before.
  static void remember_rates(FluidState& all) {
    const std::array<Scalars*, 3> rates{&all.ax, &all.ay, &all.drho};
    for (std::size_t k = 0; k < 3; ++k) {
      all.past[k].swap(all.past[k + 3]);
      all.past[k].swap(*rates[k]);
    }
  }

  int known_ = 0;       // rates of past steps
  double last_dt_ = 0;  // s
};

}  // namespace touchstone
