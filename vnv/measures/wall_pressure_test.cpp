#include "vnv/measures/wall_pressure.hpp"

#include "solvers/lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace touchstone::vnv {
namespace wall_pressure_test {

constexpr double rho = 1000, g = 9.81, wall = 1, depth = 0.3;
constexpr double P2 = 0.015, diameter = 0.0042;  // as in Lobovský's tank

/// Water at rest before a wall, from a floor at y = 0 to its surface.
Samples at_rest(double spacing, double gap_at_wall = 0) {
  Samples s;
  s.x = lattice({.low = {wall - 0.3, 0}, .high = {wall, depth}}, spacing).places();
  s.x.row(0).array() -= gap_at_wall;
  s.v = Vectors::Zero(2, s.size());
  s.density = Scalars::Constant(s.size(), rho);
  s.mass = s.density * spacing * spacing;
  s.pressure = rho * g * (depth - s.x.row(1).transpose().array());
  return s;
}

Samples only(const Samples& all, const std::vector<Eigen::Index>& chosen) {
  Samples s = all;
  s.x = all.x(Eigen::all, chosen);
  s.v = all.v(Eigen::all, chosen);
  s.mass = all.mass(chosen);
  s.density = all.density(chosen);
  s.pressure = all.pressure(chosen);
  return s;
}

TEST(FittedWallPressure, IsHydrostaticAtAnyHeightAndSpacing) {
  for (const double spacing : {0.03, 0.015, 0.0075, 0.00375})
    for (const double height : {0.003, 0.015, 0.03, 0.08, 0.29})
      EXPECT_NEAR(fitted_wall_pressure(at_rest(spacing), {wall, height, diameter}, spacing), rho * g * (depth - height),
                  1e-7)
          << spacing << ' ' << height;
}

TEST(FittedWallPressure, IsThatOfAFaceAndNotOnlyOfItsCentre) {
  // A face of 0.09 m whose upper third is above the surface: its wet part, 0.06 m, is under 0.03 m on average.
  EXPECT_NEAR(fitted_wall_pressure(at_rest(0.01), {wall, depth - 0.015, 0.09}, 0.01), rho * g * 0.03 * 2 / 3, 1e-7);
}

TEST(FittedWallPressure, IsReadAtTheWallAndNotBeforeIt) {
  Samples s = at_rest(0.01, 0.003);
  s.pressure = 5000 * s.x.row(0).transpose().array();
  EXPECT_NEAR(fitted_wall_pressure(s, {wall, 0.1, diameter}, 0.01), 5000 * wall, 1e-7);
}

TEST(FittedWallPressure, OfAnyFieldIsThatOfTheAffineFunctionOfLeastSquaresByItsWeights) {
  constexpr double spacing = 0.01, height = 0.1, reach = diameter / 2 + 2.5 * spacing;
  Samples s = at_rest(spacing, 0.002);
  for (Eigen::Index p = 0; p < s.size(); ++p) {
    s.pressure(p) = 1e6 * (std::pow(s.x(0, p) - wall, 2) + std::pow(s.x(1, p) - 0.07, 3));
    s.mass(p) *= 1 + 0.5 * std::sin(40.0 * static_cast<double>(p));
  }
  std::vector<Eigen::Vector4d> rows;  // times the root of each weight: 1, along both axes, pressure
  for (Eigen::Index p = 0; p < s.size(); ++p) {
    const Vec2 way = Vec2(s.x.col(p)) - Vec2(wall, height);
    if (way.norm() < reach)
      rows.push_back(std::sqrt(s.mass(p)) * (1 - way.squaredNorm() / (reach * reach)) *
                     Eigen::Vector4d(1, way.x(), way.y(), s.pressure(p)));
  }
  Eigen::MatrixX4d all(std::ssize(rows), 4);
  for (Eigen::Index k = 0; k < all.rows(); ++k) all.row(k) = rows[static_cast<std::size_t>(k)];
  const Eigen::Vector3d fitted = Eigen::MatrixX3d(all.leftCols<3>()).householderQr().solve(all.col(3));
  EXPECT_NEAR(fitted_wall_pressure(s, {wall, height, diameter}, spacing), fitted(0), 1e-9 * std::abs(fitted(0)));
}

TEST(FittedWallPressure, OfTooFewParticlesForSlopesIsTheirMean) {
  Samples s = only(at_rest(0.01), {29});  // the lowest row ends at the wall
  ASSERT_NEAR(s.x(0, 0), wall - 0.005, 1e-12);
  s.pressure(0) = 7;
  EXPECT_NEAR(fitted_wall_pressure(s, {wall, 0.005, diameter}, 0.01), 7, 1e-12);
}

TEST(MeanWallPressure, IsHydrostaticWhereThePatchCutsParticlesEvenly) {
  for (const double spacing : {0.03, 0.015, 0.01})
    for (const double rows : {4.0, 4.5})
      EXPECT_NEAR(mean_wall_pressure(at_rest(spacing), {wall, rows * spacing, diameter}, spacing),
                  rho * g * (depth - rows * spacing), 1e-7)
          << spacing << ' ' << rows;
}

TEST(MeanWallPressure, IsHydrostaticToAFractionOfASpacingElsewhere) {
  for (const double spacing : {0.015, 0.0075, 0.00375, 0.0009375})
    for (const double height : {0.003, 0.015, 0.03, 0.08})
      EXPECT_NEAR(mean_wall_pressure(at_rest(spacing), {wall, height, diameter}, spacing), rho * g * (depth - height),
                  0.3 * rho * g * spacing)
          << spacing << ' ' << height;
}

TEST(MeanWallPressure, IsOfAPatchOfTheSensorOrOfTheSpacing) {
  // Particles of 0.01 m: a patch of 0.015 m about their lowest two rows' border has half of each but one quarter.
  Samples s = at_rest(0.01);
  s.pressure = (s.x.row(1).transpose().array() < 0.01).cast<double>();
  EXPECT_NEAR(mean_wall_pressure(s, {wall, 0.01, diameter}, 0.01), 0.5, 1e-12);
  EXPECT_NEAR(mean_wall_pressure(s, {wall, 0.015, 0.03}, 0.01), 1.0 / 3, 1e-12) << "a sensor larger than that";
  s.pressure = (s.x.row(0).transpose().array() > wall - 0.01).cast<double>();
  EXPECT_NEAR(mean_wall_pressure(s, {wall, 0.1, diameter}, 0.01), 2.0 / 3, 1e-12) << "1.5 spacings into the fluid";
}

TEST(WallPressure, CountsADryPartOfTheFaceAsNone) {
  Samples s = at_rest(0.01);
  s.pressure.setConstant(600);
  const WallSensor half_wet{wall, depth, 0.02};
  EXPECT_NEAR(mean_wall_pressure(s, half_wet, 0.01), 300, 1e-9);
  EXPECT_NEAR(fitted_wall_pressure(s, half_wet, 0.01), 300, 1e-9);
  for (const double gap : {0.004, 0.012})
    EXPECT_NEAR(mean_wall_pressure(at_rest(0.01, gap), {wall, 0.1, diameter}, 0.01), rho * g * 0.2, 1e-7)
        << "a gap before the wall, as repulsive walls leave, is no dry part";
}

TEST(WallPressure, IsNoneWithoutWaterAtTheFace) {
  const Samples s = at_rest(0.01);
  for (const WallSensor& dry : {WallSensor{wall, depth + 0.02, diameter}, {wall + 0.05, 0.1, diameter}}) {
    EXPECT_EQ(mean_wall_pressure(s, dry, 0.01), 0);
    EXPECT_EQ(fitted_wall_pressure(s, dry, 0.01), 0);
  }
}

TEST(WallPressure, IsNoNumberForSamplesThatAreNone) {
  const WallSensor sensor{wall, P2, diameter};
  for (int kind = 0; kind < 4; ++kind) {
    Samples s = at_rest(0.01);
    if (kind == 0) s.pressure(29) = not_a_number;
    if (kind == 1) s.x(1, 500) = not_a_number;
    if (kind == 2) s.density(500) = not_a_number;
    if (kind == 3) s = only(s, {});
    EXPECT_TRUE(std::isnan(mean_wall_pressure(s, sensor, 0.01))) << kind;
    EXPECT_TRUE(std::isnan(fitted_wall_pressure(s, sensor, 0.01))) << kind;
  }
  EXPECT_THROW(mean_wall_pressure(at_rest(0.01), {wall, P2, 0}, 0.01), std::invalid_argument);
  EXPECT_THROW(fitted_wall_pressure(at_rest(0.01), sensor, 0), std::invalid_argument);
}

}  // namespace wall_pressure_test
}  // namespace touchstone::vnv
