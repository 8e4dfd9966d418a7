#pragma once
#include "solvers/sph/particles.hpp"
#include "solvers/threads.hpp"

namespace touchstone::sph {

/// What a particle carries from the rates to the next drift, a motion besides that of the fluid: its direction and the
/// slopes of what changes on the way.
enum DriftField { drift_x, drift_y, vx_along_x, vx_along_y, vy_along_x, vy_along_y, rho_along_x, rho_along_y };
inline constexpr std::size_t drift_fields = 8;

/// Moves particles by so many times their drift; velocity and density change as their slopes say.
inline void drift(Particles& all, double times, Index begin, Index end) {
  const auto part = Eigen::seqN(begin, end - begin);
  const Scalars x = times * all.carried[drift_x](part), y = times * all.carried[drift_y](part);
  const auto change = [&](DriftField slope_x, DriftField slope_y) {
    return x * all.carried[slope_x](part) + y * all.carried[slope_y](part);
  };
  all.x(part) += x;
  all.y(part) += y;
  all.vx(part) += change(vx_along_x, vx_along_y);
  all.vy(part) += change(vy_along_x, vy_along_y);
  all.rho(part) += change(rho_along_x, rho_along_y);
}

}  // namespace touchstone::sph
