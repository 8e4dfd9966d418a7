#pragma once
#include "vnv/bench/plain_grid.hpp"

namespace touchstone::bench {

struct MlsParticle {
  double x, y, vx = 0, vy = 0;                // m, m/s
  double cxx = 0, cxy = 0, cyx = 0, cyy = 0;  // 1/s  the affine matrix, the velocity's gradient
  double mass, density;                       // kg/m, kg/m³
};
struct MlsNode {
  double mass = 0;        // kg/m
  double vx = 0, vy = 0;  // m/s   momentum [kg/s] until divided by the mass
};

/// The moving least squares material point method as its 88-line program has it (Hu et al., ACM Trans. Graph. 37 (2018)
/// 150): quadratic B-splines, nine nodes, affine velocities (APIC), the stress by the affine matrix. Here for a fluid:
/// pressure from the density by Tait's law, viscosity from the affine matrix as the velocity gradient.
class MlsMpm : public PlainMpm<MlsParticle, MlsNode, 1> {
 public:
  using PlainMpm::PlainMpm;

  void step() {
    for (Node& node : nodes_) node = {};
    for (const Particle& p : particles_) scatter(p);
    for (Node& node : nodes_) find_velocity(node);
    for (int node : grid_.held(0)) nodes_[node].vx = 0;
    for (int node : grid_.held(1)) nodes_[node].vy = 0;
    for (Particle& p : particles_) gather(p);
  }

 private:
  struct Weights {
    int column, row;    // of the first of three nodes along each axis; the middle one is the nearest
    double f, g;        // cells  from the first node to the particle
    double x[3], y[3];  // -
  };

  Weights weights(const Particle& p) const {
    const double X = p.x * grid_.per_cell().x(), Y = p.y * grid_.per_cell().y();
    const int column = static_cast<int>(X + 0.5) - 1, row = static_cast<int>(Y + 0.5) - 1;
    const double f = X - column, g = Y - row;
    return {column,
            row,
            f,
            g,
            {0.5 * (1.5 - f) * (1.5 - f), 0.75 - (f - 1) * (f - 1), 0.5 * (f - 0.5) * (f - 0.5)},
            {0.5 * (1.5 - g) * (1.5 - g), 0.75 - (g - 1) * (g - 1), 0.5 * (g - 0.5) * (g - 0.5)}};
  }

  void scatter(const Particle& p) {
    const Weights near = weights(p);
    const double dx = grid_.cell().x(), dy = grid_.cell().y(), a = grid_.per_cell().x(), b = grid_.per_cell().y();
    const PlainStress s = flow_.stress(p.density, p.cxx, p.cxy, p.cyx, p.cyy);
    const double impulse = -4 * dt_ * p.mass / p.density;  // 4 / cell² is the inverse inertia of the spline
    const double xx = p.mass * p.cxx + impulse * s.xx * a * a, xy = p.mass * p.cxy + impulse * s.xy * b * b;
    const double yx = p.mass * p.cyx + impulse * s.xy * a * a, yy = p.mass * p.cyy + impulse * s.yy * b * b;
    const double px = p.mass * (p.vx + dt_ * flow_.force.x()), py = p.mass * (p.vy + dt_ * flow_.force.y());
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        const double x = (i - near.f) * dx, y = (j - near.g) * dy, weight = near.x[i] * near.y[j];
        Node& node = nodes_[grid_.node(near.column + i, near.row + j)];
        node.mass += weight * p.mass;
        node.vx += weight * (px + xx * x + xy * y);
        node.vy += weight * (py + yx * x + yy * y);
      }
  }

  static void find_velocity(Node& node) {
    if (node.mass == 0) return;
    node.vx /= node.mass;
    node.vy /= node.mass;
  }

  void gather(Particle& p) const {
    const Weights near = weights(p);
    const double a = grid_.per_cell().x(), b = grid_.per_cell().y();
    double vx = 0, vy = 0, xx = 0, xy = 0, yx = 0, yy = 0;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        const Node& node = nodes_[grid_.node(near.column + i, near.row + j)];
        const double weight = near.x[i] * near.y[j], X = i - near.f, Y = j - near.g;
        vx += weight * node.vx;
        vy += weight * node.vy;
        xx += weight * node.vx * X;
        xy += weight * node.vx * Y;
        yx += weight * node.vy * X;
        yy += weight * node.vy * Y;
      }
    p.vx = vx;
    p.vy = vy;
    p.cxx = 4 * a * xx;
    p.cxy = 4 * b * xy;
    p.cyx = 4 * a * yx;
    p.cyy = 4 * b * yy;
    p.x = grid_.wrapped(p.x + dt_ * vx);
    p.y += dt_ * vy;
    p.density /= 1 + dt_ * (p.cxx + p.cyy);
  }
};

}  // namespace touchstone::bench
