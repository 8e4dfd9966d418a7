#pragma once
/// Errors of a flow in the plane, particle by particle.

#include "vnv/case.hpp"

#include <functional>

namespace touchstone::vnv {

/// The truth at a place [m] and a time [s].
using VelocityTruth = std::function<Vec2(const Vec2& x, double t)>;
using PressureTruth = std::function<double(const Vec2& x, double t)>;

inline const Quantity l2_velocity{"L2 v, per particle", "%", Kind::norm},
    linf_velocity{"Linf v, per particle", "%", Kind::norm};
inline const Quantity l2_pressure{"L2 p - mean(p), per particle", "%", Kind::norm};

/// Relative L2 norm of the velocity's error, weighted by volume: sqrt(sum V |e - n|² / sum V |e|²).
double relative_l2_of_velocity(const Samples& samples, const VelocityTruth& truth);

/// The largest |e - n| over the largest |e|.
double relative_linf_of_velocity(const Samples& samples, const VelocityTruth& truth);

/// Both norms of the velocity, in per cent, at every time of a run.
Measurement velocity_errors(VelocityTruth truth);

/// The L2 norm of the pressure, in per cent, at every time of a run. In a fluid without a free surface only differences
/// of pressure move anything: the volume means of both are taken off.
Measurement pressure_errors(PressureTruth truth);

/// How much of the exact pressure is in the one found: the coefficient of the least-squares fit of the latter by the
/// former, 1 if it is right, 0 without pressure, -1 of the wrong sign; noise hardly changes it. With `less_mean` only
/// differences of pressure count.
inline const Quantity part_of_pressure{"part of the exact pressure that is found"};
Measurement part_of_exact_pressure(PressureTruth truth, bool less_mean);

/// The volume mean of the pressure over that of a unit [Pa].
Measurement mean_pressure(const Quantity& quantity, double unit);

}  // namespace touchstone::vnv
