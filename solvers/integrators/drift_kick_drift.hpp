#pragma once
#include "solvers/integrators/motions.hpp"
#include "solvers/stepping/laps.hpp"

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
    FluidState& all = flow.state();
    const int threads = flow.threads();
    drift(all, threads, dt / 2);
    lap(SubStep::motion);
    flow.find_density_rate(time + dt / 2, lap);
    thicken(all, threads, dt / 2);
    lap(SubStep::motion);
    flow.find_accelerations(time + dt / 2, lap);
    kick(all, threads, dt);
    lap(SubStep::motion);
    flow.find_density_rate(time + dt / 2, lap);
    thicken(all, threads, dt / 2);
    drift(all, threads, dt / 2);
    lap(SubStep::motion);
  }
};

}  // namespace touchstone
