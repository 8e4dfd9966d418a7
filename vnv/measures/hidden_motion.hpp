#pragma once
/// What of the particles' motion the method cannot see.

#include "solvers/samples.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::vnv {

/// Root mean square of what is left of the particles' velocities after a linear fit around each of them, to the
/// particles within `reach` [m], over that of the velocities: motion of one particle against the next. Modes of it in
/// which the nodes of the material point method see nothing live on for ever (null-space modes). For up to some
/// thousand particles: each is compared with all.
inline double hidden_motion(const Samples& s, double reach) {
  double left = 0, all = 0;
  for (Eigen::Index i = 0; i < s.size(); ++i) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 2> sums = Eigen::Matrix<double, 3, 2>::Zero();
    int near = 0;
    for (Eigen::Index j = 0; j < s.size(); ++j) {
      const Vec2 off = (s.x.col(j) - s.x.col(i)) / reach;
      if (off.squaredNorm() > 1) continue;
      const Eigen::Vector3d terms(1, off.x(), off.y());
      normal += terms * terms.transpose();
      sums += terms * s.v.col(j).transpose();
      ++near;
    }
    if (near < 6) continue;  // hardly more than the fit has unknowns
    const Vec2 fitted = normal.ldlt().solve(sums).row(0).transpose();
    left += (Vec2(s.v.col(i)) - fitted).squaredNorm();
    all += s.v.col(i).squaredNorm();
  }
  return all > 0 ? std::sqrt(left / all) : 0;
}

/// The distance of the closest two particles [m]: in smoothed particle hydrodynamics they pair where the kernel's slope
/// no longer pushes them apart (tensile or pairing instability). Infinite for fewer than two.
inline double closest_pair(const Samples& s) {
  double closest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < s.size(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) closest = std::min(closest, (s.x.col(i) - s.x.col(j)).squaredNorm());
  return std::sqrt(closest);
}

}  // namespace touchstone::vnv
