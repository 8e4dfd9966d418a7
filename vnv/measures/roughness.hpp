#pragma once
/// How rough a field is from particle to particle, where no exact field is known.

#include "vnv/case.hpp"
#include "vnv/measures/profile.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <compare>
#include <string>
#include <vector>

namespace touchstone::vnv {

/// The root mean square over all particles of how far a field at each is from the plane of least squares through those
/// within `radius` [m] of it, itself among them; in the unit of the field. Zero for a field that is linear in place.
/// Particles whose neighbours, fewer than six or in a line, bear no plane are left out; not a number if all are.
inline double roughness(const Samples& samples, const ParticleField& field, double radius) {
  struct Binned {
    long column, row;
    Eigen::Index p;
    auto operator<=>(const Binned&) const = default;
  };
  std::vector<Binned> bins;
  for (Eigen::Index p = 0; p < samples.size(); ++p)
    bins.push_back(
        {std::lround(std::floor(samples.x(0, p) / radius)), std::lround(std::floor(samples.x(1, p) / radius)), p});
  std::ranges::sort(bins);

  const auto off_the_plane = [&](const Binned& at) {
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    Eigen::Vector3d sums = Eigen::Vector3d::Zero();
    for (const long column : {at.column - 1, at.column, at.column + 1})
      for (auto near = std::ranges::lower_bound(bins, Binned{column, at.row - 1, 0});
           near != bins.end() && near->column == column && near->row <= at.row + 1; ++near) {
        const Vec2 away = (samples.x.col(near->p) - samples.x.col(at.p)) / radius;
        if (!(away.squaredNorm() < 1)) continue;
        const Eigen::Vector3d basis(1, away.x(), away.y());
        moments += basis * basis.transpose();
        sums += basis * (field(samples, near->p) - field(samples, at.p));
      }
    const Eigen::LDLT<Eigen::Matrix3d> solver(moments);
    const bool bears_a_plane = moments(0, 0) >= 6 && solver.vectorD().minCoeff() > 1e-6 * moments(0, 0);
    return bears_a_plane ? solver.solve(sums)[0] : not_a_number;
  };

  double squares = 0, count = 0;
  for (const Binned& at : bins) {
    if (std::isnan(field(samples, at.p))) return not_a_number;
    if (const double off = off_the_plane(at); !std::isnan(off)) squares += off * off, ++count;
  }
  return std::sqrt(squares / count);
}

/// "NAME roughness over SCALE_NAME [%]", with neighbours within 2.5 spacings, at those times [s] of a run, or at
/// all.
inline Measurement roughness_of(std::string name, ParticleField field, std::string scale_name, double scale,
                                std::vector<double> times = {}) {
  return [=](const Level& level, const Run& run) {
    std::vector<Value> errors;
    const auto add = [&](const Samples& samples) {
      errors.push_back({level.name,
                        level.spacing,
                        samples.time,
                        {fmt::format("{} roughness over {}", name, scale_name), "%", Kind::error},
                        100 * roughness(samples, field, 2.5 * level.spacing) / scale});
    };
    if (times.empty()) std::ranges::for_each(run.samples, add);
    for (const double time : times)
      if (const Samples* samples = run.at(time)) add(*samples);
    return errors;
  };
}

}  // namespace touchstone::vnv
