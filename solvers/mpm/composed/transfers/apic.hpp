#pragma once
#include "solvers/mpm/composed/plain_transfer.hpp"

namespace touchstone::mpm {

/// Particles take from the nodes their velocity and how it changes around them, v + C (x - x_p) (APIC, Jiang,
/// Schroeder, Selle, Teran & Stomakhin, ACM Trans. Graph. 34 (2015) 51), with C = sum v_i (w_i (x_i - x_p) / D)^T.
///
/// Linear momentum is conserved; angular momentum, sum m_p (x_p x v_p + D_x C_yx - D_y C_xy), with shapes whose spread
/// D is the same everywhere: B-splines of second and third degree away from edges. With hats C is the slope of the
/// velocity.
class Apic {
 public:
  Vec2 given(const PlainParticles& particles, Index p, const Vec2& arm) const {
    return particles.v.col(p) + affine_[p] * arm;
  }

  /// Of particles that are set going, their slopes.
  void begin(const PlainParticles& particles) {
    for (const Slopes<double>& of_v : particles.slopes) affine_.push_back(Mat2{{of_v.xx, of_v.xy}, {of_v.yx, of_v.yy}});
  }

  template <class Shape>
  void gather(const Weights<Shape>& weights, const PlainNodes& nodes, int threads, PlainParticles& particles) {
    for_particles(particles, threads, [&](Index p) {
      Mat2 sum = Mat2::Zero();
      weights.for_nodes_near(
          p, [&](int node, const Tie& tie) { sum += nodes.velocity.col(node) * tie.affine_slope.transpose(); });
      affine_[p] = sum;
      particles.v.col(p) = weights.at(p, nodes.velocity);
    });
  }

 private:
  std::vector<Mat2> affine_;  // 1/s  C of each particle
};

}  // namespace touchstone::mpm
