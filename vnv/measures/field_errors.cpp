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

Measurement part_of_exact_pressure(PressureTruth truth, bool less_mean) {
  return [truth = std::move(truth), less_mean](const Level& level, const Run& run) {
    std::vector<Value> found;
    for (const Samples& s : run.samples) {
      const Scalars volumes = s.volumes();
      Scalars exact(s.size());
      for (Eigen::Index p = 0; p < s.size(); ++p) exact[p] = truth(s.x.col(p), s.time);
      if (less_mean) exact -= (exact * volumes).sum() / volumes.sum();
      const double scale = (volumes * exact.square()).sum();
      norms::require_scale("part_of_exact_pressure", scale);
      found.push_back(
          {level.name, level.spacing, s.time, part_of_pressure, (volumes * s.pressure * exact).sum() / scale});
    }
    return found;
  };
}

Measurement mean_pressure(const Quantity& quantity, double unit) {
  return [=](const Level& level, const Run& run) {
    std::vector<Value> found;
    for (const Samples& s : run.samples) {
      const Scalars volumes = s.volumes();
      found.push_back(
          {level.name, level.spacing, s.time, quantity, (volumes * s.pressure).sum() / volumes.sum() / unit});
    }
    return found;
  };
}

}  // namespace touchstone::vnv
