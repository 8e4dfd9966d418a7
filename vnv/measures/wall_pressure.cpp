#include "vnv/measures/wall_pressure.hpp"

#include "vnv/measures/front.hpp"
#include "vnv/measures/wet_extents.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace touchstone::vnv {
namespace {

constexpr double reach_into_fluid = 1.5;  // spacings from the wall: the first row or two of particles

/// Where water stands before a face, of the part of it that is above the floor.
struct Wetting {
  double fraction = 0;  // of the face
  double middle = 0;    // m  of the wet part
};

Range strip_at(const WallSensor& sensor, double spacing) {
  return {sensor.wall - reach_into_fluid * spacing, std::numeric_limits<double>::infinity()};
}

Range face_of(const WallSensor& sensor, double across) {
  return {std::max(0.0, sensor.height - across / 2), sensor.height + across / 2};
}

/// Gaps of up to half a spacing are between particles.
Wetting wetting_of(const Samples& samples, const WallSensor& sensor, const Range& face, double spacing) {
  double length = 0, moment = 0;
  for (const Range& wet : wet_extents(samples, strip_at(sensor, spacing), spacing / 2)) {
    const Range here = common(wet, face);
    length += here.length();
    moment += here.length() * (here.low + here.high) / 2;
  }
  return length > 0 ? Wetting{length / face.length(), moment / length} : Wetting{};
}

void require(const WallSensor& sensor, double spacing) {
  if (!(sensor.diameter > 0 && spacing > 0 && sensor.height + sensor.diameter / 2 > 0))
    throw std::invalid_argument(fmt::format(
        "wall sensor: height {} m, diameter {} m, spacing {} m, expected positive lengths and a face above the floor",
        sensor.height, sensor.diameter, spacing));
}

/// The affine function that fits pressures within `reach` [m] of a place best, weighted by volume times (1 - r² /
/// reach²)², at another place; their weighted mean where the particles do not tell its slopes apart.
double affine_fit(const Samples& samples, const Vec2& around, double reach, const Vec2& at) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();
  for (Eigen::Index p = 0; p < samples.size(); ++p) {
    const double left = 1 - (samples.x.col(p) - around).squaredNorm() / (reach * reach);
    if (left <= 0) continue;
    const Vec2 way = (samples.x.col(p) - at) / reach;
    const Eigen::Vector3d shape(1, way.x(), way.y());
    const double weight = samples.mass(p) / samples.density(p) * left * left;
    moments += weight * shape * shape.transpose();
    sums += weight * samples.pressure(p) * shape;
  }
  if (moments(0, 0) == 0) return 0;
  constexpr double told_apart = 3e-3;  // least eigenvalue by weight; of a lattice in a quarter disc it is 0.01 or more
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> values(moments / moments(0, 0), Eigen::EigenvaluesOnly);
  return values.eigenvalues()(0) > told_apart ? moments.ldlt().solve(sums)(0) : sums(0) / moments(0, 0);
}

}  // namespace

double mean_wall_pressure(const Samples& samples, const WallSensor& sensor, double spacing) {
  require(sensor, spacing);
  if (!fronts::known(samples)) return not_a_number;
  const Range face = face_of(sensor, std::max(sensor.diameter, reach_into_fluid * spacing));
  double force = 0, area = 0;
  each_inside(samples, strip_at(sensor, spacing), [&](Eigen::Index p, const Range& across, const Range& all) {
    const double part = across.length() * common(all, face).length();
    if (part == 0) return;
    force += part * samples.pressure(p);
    area += part;
  });
  return area > 0 ? force / area * wetting_of(samples, sensor, face, spacing).fraction : 0;
}

double fitted_wall_pressure(const Samples& samples, const WallSensor& sensor, double spacing) {
  require(sensor, spacing);
  if (!fronts::known(samples)) return not_a_number;
  const Range face = face_of(sensor, sensor.diameter);
  const Wetting wetting = wetting_of(samples, sensor, face, spacing);
  if (wetting.fraction == 0) return 0;
  const double reach = sensor.diameter / 2 + 2.5 * spacing;
  return wetting.fraction * affine_fit(samples, {sensor.wall, sensor.height}, reach, {sensor.wall, wetting.middle});
}

}  // namespace touchstone::vnv
