#include "vnv/measures/hidden_motion.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::vnv {

double hidden_motion(const Samples& s, double reach) {
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

double closest_pair(const Samples& s) {
  double closest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < s.size(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) closest = std::min(closest, (s.x.col(i) - s.x.col(j)).squaredNorm());
  return std::sqrt(closest);
}

}  // namespace touchstone::vnv
