#pragma once
/// What a pressure sensor in an upright wall reads. The answer depends on the operator, and a computation of an impact
/// may differ by several times between two, so there are two: tell both.
///
/// Both read over the sensor's face the force by its area: where only a part of the face is wet, the rest counts as 0.
/// Both follow the spacing of the particles, as a face of a few millimetres may be smaller than it. Without water at
/// the face they read 0. For samples without particles, with a place or volume that is no finite number, or a pressure
/// near the sensor that is none, they give not a number.

#include "vnv/measures/wet_extents.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <limits>
#include <stdexcept>

namespace touchstone::vnv {

/// A disc in a wall at x = `wall`, with the fluid at lesser x, above a floor at y = 0.
struct WallSensor {
  double wall;      // m
  double height;    // m  of its centre
  double diameter;  // m
};

namespace sensing {

constexpr double reach_into_fluid = 1.5;  // spacings from the wall: the first row or two of particles

/// Where water stands before a face, of the part of it that is above the floor.
struct Wetting {
  double fraction = 0;  // of the face
  double middle = 0;    // m  of the wet part
};

inline Extent strip_at(const WallSensor& sensor, double spacing) {
  return {sensor.wall - reach_into_fluid * spacing, std::numeric_limits<double>::infinity()};
}

inline Extent face(const WallSensor& sensor, double across) {
  return {std::max(0.0, sensor.height - across / 2), sensor.height + across / 2};
}

/// Gaps of up to half a spacing are between particles.
inline Wetting wetting(const Samples& samples, const WallSensor& sensor, const Extent& face, double spacing) {
  double length = 0, moment = 0;
  for (const Extent& wet : wet_extents(samples, strip_at(sensor, spacing), spacing / 2)) {
    const Extent here = common(wet, face);
    length += here.length();
    moment += here.length() * (here.low + here.high) / 2;
  }
  return length > 0 ? Wetting{length / face.length(), moment / length} : Wetting{};
}

inline void require(const WallSensor& sensor, double spacing) {
  if (!(sensor.diameter > 0 && spacing > 0 && sensor.height + sensor.diameter / 2 > 0))
    throw std::invalid_argument(fmt::format(
        "wall sensor: height {} m, diameter {} m, spacing {} m, expected positive lengths and a face above the floor",
        sensor.height, sensor.diameter, spacing));
}

/// The affine function that fits pressures within `reach` [m] of a place best, weighted by volume times (1 - r² /
/// reach²)², at another place; their weighted mean where the particles do not tell its slopes apart.
inline double affine_fit(const Samples& samples, const Vec2& around, double reach, const Vec2& at) {
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

}  // namespace sensing

/// The mean pressure [Pa] of what lies within 1.5 spacings of the wall, over the sensor's diameter or 1.5 spacings of
/// height, whichever is more. It reads half that far into the fluid; a patch that the floor cuts off reads in the
/// middle of the rest. Where the edges of a patch cut particles evenly, a hydrostatic pressure is read exactly, else to
/// a fraction of a spacing. Throws std::invalid_argument for lengths that are not positive.
inline double mean_wall_pressure(const Samples& samples, const WallSensor& sensor, double spacing) {
  sensing::require(sensor, spacing);
  if (!fronts::known(samples)) return not_a_number;
  const Extent face = sensing::face(sensor, std::max(sensor.diameter, sensing::reach_into_fluid * spacing));
  double force = 0, area = 0;
  each_inside(samples, sensing::strip_at(sensor, spacing),
              [&](Eigen::Index p, const Extent& across, const Extent& all) {
                const double part = across.length() * common(all, face).length();
                if (part == 0) return;
                force += part * samples.pressure(p);
                area += part;
              });
  return area > 0 ? force / area * sensing::wetting(samples, sensor, face, spacing).fraction : 0;
}

/// The pressure [Pa] at the wall, by the affine function that fits those within 2.5 spacings of the sensor's face best,
/// in the middle of the wet part of its face: a mean over the face, as the function is affine. A hydrostatic pressure
/// is read exactly at any height, up to floor and surface. Throws std::invalid_argument for lengths that are not
/// positive.
inline double fitted_wall_pressure(const Samples& samples, const WallSensor& sensor, double spacing) {
  sensing::require(sensor, spacing);
  if (!fronts::known(samples)) return not_a_number;
  const Extent face = sensing::face(sensor, sensor.diameter);
  const sensing::Wetting wetting = sensing::wetting(samples, sensor, face, spacing);
  if (wetting.fraction == 0) return 0;
  const double reach = sensor.diameter / 2 + 2.5 * spacing;
  return wetting.fraction *
         sensing::affine_fit(samples, {sensor.wall, sensor.height}, reach, {sensor.wall, wetting.middle});
}

}  // namespace touchstone::vnv
