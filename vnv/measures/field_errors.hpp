#pragma once
/// Errors of a flow in the plane, particle by particle.

#include "vnv/case.hpp"
#include "vnv/judge/norms.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::vnv {

/// The truth at a place [m] and a time [s].
using VelocityTruth = std::function<Vec2(const Vec2& x, double t)>;
using PressureTruth = std::function<double(const Vec2& x, double t)>;

inline const Quantity l2_velocity{"L2 v, per particle", "%", Kind::norm},
    linf_velocity{"Linf v, per particle", "%", Kind::norm};
inline const Quantity l2_pressure{"L2 p - mean(p), per particle", "%", Kind::norm};

/// Relative L2 norm of the velocity's error, weighted by volume: sqrt(sum V |e - n|² / sum V |e|²).
inline double relative_l2_of_velocity(const Samples& samples, const VelocityTruth& truth) {
  const Scalars volumes = samples.volumes();
  double error = 0, scale = 0;
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    const Vec2 exact = truth(samples.x.col(p), samples.time);
    error += volumes[p] * (exact - samples.v.col(p)).squaredNorm();
    scale += volumes[p] * exact.squaredNorm();
  }
  norms::require_scale("relative_l2_of_velocity", scale);
  return std::sqrt(error / scale);
}

/// The largest |e - n| over the largest |e|.
inline double relative_linf_of_velocity(const Samples& samples, const VelocityTruth& truth) {
  double error = 0, scale = 0;
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    const Vec2 exact = truth(samples.x.col(p), samples.time);
    error = norms::larger_magnitude(error, (exact - samples.v.col(p)).norm());
    scale = norms::larger_magnitude(scale, exact.norm());
  }
  norms::require_scale("relative_linf_of_velocity", scale);
  return error / scale;
}

/// Both norms of the velocity, in per cent, at every time of a run.
inline Measurement velocity_errors(VelocityTruth truth) {
  return [truth = std::move(truth)](const Level& level, const Run& run) {
    std::vector<Value> errors;
    for (const Samples& s : run.samples) {
      errors.push_back({level.name, level.spacing, s.time, l2_velocity, 100 * relative_l2_of_velocity(s, truth)});
      errors.push_back({level.name, level.spacing, s.time, linf_velocity, 100 * relative_linf_of_velocity(s, truth)});
    }
    return errors;
  };
}

/// The L2 norm of the pressure, in per cent, at every time of a run. In a fluid without a free surface only differences
/// of pressure move anything: the volume means of both are taken off.
inline Measurement pressure_errors(PressureTruth truth) {
  return [truth = std::move(truth)](const Level& level, const Run& run) {
    std::vector<Value> errors;
    for (const Samples& s : run.samples) {
      const Scalars volumes = s.volumes();
      Scalars exact(s.size());
      for (Eigen::Index p = 0; p < s.size(); ++p) exact[p] = truth(s.x.col(p), s.time);
      const auto less_mean = [&](const Scalars& field) -> Scalars {
        return field - (field * volumes).sum() / volumes.sum();
      };
      const Scalars n = less_mean(s.pressure), e = less_mean(exact);
      const auto values = [](const Scalars& field) {
        return Values(field.data(), static_cast<std::size_t>(field.size()));
      };
      errors.push_back(
          {level.name, level.spacing, s.time, l2_pressure, 100 * relative_l2(values(n), values(e), values(volumes))});
    }
    return errors;
  };
}

}  // namespace touchstone::vnv
