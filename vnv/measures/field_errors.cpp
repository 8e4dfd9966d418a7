#include "vnv/measures/field_errors.hpp"

#include "vnv/judge/norms.hpp"

#include <cmath>
#include <utility>

namespace touchstone::vnv {

double relative_l2_of_velocity(const Samples& samples, const VelocityTruth& truth) {
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

double relative_linf_of_velocity(const Samples& samples, const VelocityTruth& truth) {
  double error = 0, scale = 0;
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    const Vec2 exact = truth(samples.x.col(p), samples.time);
    error = norms::larger_magnitude(error, (exact - samples.v.col(p)).norm());
    scale = norms::larger_magnitude(scale, exact.norm());
  }
  norms::require_scale("relative_linf_of_velocity", scale);
  return error / scale;
}

namespace {

Scalars exact_at(const Samples& s, const PressureTruth& truth) {
  Scalars exact(s.size());
  for (Eigen::Index p = 0; p < s.size(); ++p) exact[p] = truth(s.x.col(p), s.time);
  return exact;
}

double volume_mean(const Samples& s, const Scalars& field) {
  const Scalars volumes = s.volumes();
  return (volumes * field).sum() / volumes.sum();
}

/// A quantity at every time of a run.
template <class ValueOf>
Measurement at_every_time(const Quantity& quantity, ValueOf value) {
  return [=](const Level& level, const Run& run) {
    std::vector<Value> found;
    for (const Samples& s : run.samples) found.push_back({level.name, level.spacing, s.time, quantity, value(s)});
    return found;
  };
}

}  // namespace

Measurement velocity_errors(VelocityTruth truth) {
  return [truth = std::move(truth)](const Level& level, const Run& run) {
    std::vector<Value> errors;
    for (const Samples& s : run.samples) {
      errors.push_back({level.name, level.spacing, s.time, l2_velocity, 100 * relative_l2_of_velocity(s, truth)});
      errors.push_back({level.name, level.spacing, s.time, linf_velocity, 100 * relative_linf_of_velocity(s, truth)});
    }
    return errors;
  };
}

Measurement pressure_errors(PressureTruth truth) {
  return at_every_time(l2_pressure, [truth = std::move(truth)](const Samples& s) {
    const Scalars exact = exact_at(s, truth), n = s.pressure - volume_mean(s, s.pressure),
                  e = exact - volume_mean(s, exact), volumes = s.volumes();
    const auto values = [](const Scalars& field) {
      return Values(field.data(), static_cast<std::size_t>(field.size()));
    };
    return 100 * relative_l2(values(n), values(e), values(volumes));
  });
}

Measurement part_of_exact_pressure(PressureTruth truth, bool less_mean) {
  return at_every_time(part_of_pressure, [truth = std::move(truth), less_mean](const Samples& s) {
    const Scalars volumes = s.volumes();
    Scalars exact = exact_at(s, truth);
    if (less_mean) exact -= volume_mean(s, exact);
    const double scale = (volumes * exact.square()).sum();
    norms::require_scale("part_of_exact_pressure", scale);
    return (volumes * s.pressure * exact).sum() / scale;
  });
}

Measurement mean_pressure(const Quantity& quantity, double unit) {
  return at_every_time(quantity, [unit](const Samples& s) { return volume_mean(s, s.pressure) / unit; });
}

}  // namespace touchstone::vnv
