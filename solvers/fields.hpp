#pragma once
/// The types of places, velocities and fields in every folder. SI units throughout.

#include <Eigen/Dense>

namespace touchstone {

using Index = Eigen::Index;                                // of a particle, or a count of them
using Vec2 = Eigen::Vector2d;                              // one place [m], one velocity [m/s]
using Mat2 = Eigen::Matrix2d;                              // one stress [Pa], one velocity gradient [1/s]
using Scalars = Eigen::ArrayXd;                            // one number per particle
using Vectors = Eigen::Matrix<double, 2, Eigen::Dynamic>;  // one column per particle

inline constexpr double mm = 1e-3;   // m
inline constexpr double us = 1e-6;   // s
inline constexpr double MPa = 1e+6;  // Pa

}  // namespace touchstone
