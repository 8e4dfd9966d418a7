#pragma once
/// The motions that integrators which split a step are made of, each shared between threads.

#include "solvers/integrators/fluid_state.hpp"
#include "solvers/threads.hpp"

namespace touchstone {

/// Places, by the velocities, over dt [s].
inline void drift(FluidState& all, int threads, double dt) {
  share_out_fields(threads, all.fluid, [&](Index begin, Index end) {
    const auto part = Eigen::seqN(begin, end - begin);
    all.x(part) += dt * all.vx(part);
    all.y(part) += dt * all.vy(part);
  });
}

/// Velocities, by the accelerations.
inline void kick(FluidState& all, int threads, double dt) {
  share_out_fields(threads, all.fluid, [&](Index begin, Index end) {
    const auto part = Eigen::seqN(begin, end - begin);
    all.vx(part) += dt * all.ax(part);
    all.vy(part) += dt * all.ay(part);
  });
}

/// Densities, by their rates.
inline void thicken(FluidState& all, int threads, double dt) {
  share_out_fields(threads, all.fluid, [&](Index begin, Index end) {
    const auto part = Eigen::seqN(begin, end - begin);
    all.rho(part) += dt * all.drho(part);
  });
}

}  // namespace touchstone
