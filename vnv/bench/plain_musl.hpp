#pragma once
#include "vnv/bench/plain_grid.hpp"

namespace touchstone::bench {

struct MuslParticle {
  double x, y, vx = 0, vy = 0;  // m, m/s
  double mass, density;         // kg/m, kg/m³
  PlainStress stress{};
};
struct MuslNode {
  double mass = 0;                  // kg/m
  double px = 0, py = 0;            // kg/s  momentum, first of the old velocities, then of the new
  double fx = 0, fy = 0;            // N/m
  double ax = 0, ay = 0;            // m/s²
  double vx = 0, vy = 0;            // m/s
  double later_x = 0, later_y = 0;  // m/s   remapped
};

/// The material point method with linear hats as textbooks have it (Sulsky, Zhou & Schreyer 1995): three loops over
/// particles and their four nodes a step. The whole stress is kept whatever the fluid.
class PlainMusl : public PlainMpm<MuslParticle, MuslNode, 0> {
 public:
  using PlainMpm::PlainMpm;

  void step() {
    for (Node& node : nodes_) node = {};
    for (const Particle& p : particles_) scatter(p);
    for (Node& node : nodes_) accelerate(node);
    hold();
    for (Particle& p : particles_) change_velocity(p);
    for (Node& node : nodes_) remap(node);
    hold();
    for (Particle& p : particles_) move_and_strain(p);
  }

 private:
  struct Weights {
    int node[4];
    double value[4], slope_x[4], slope_y[4];  // -, 1/m
  };

  Weights weights(const Particle& p) const {
    const double a = grid_.per_cell().x(), b = grid_.per_cell().y();
    const int column = static_cast<int>(p.x * a), row = static_cast<int>(p.y * b);
    const double X = p.x * a - column, Y = p.y * b - row;
    return {{grid_.node(column, row), grid_.node(column + 1, row), grid_.node(column, row + 1),
             grid_.node(column + 1, row + 1)},
            {(1 - X) * (1 - Y), X * (1 - Y), (1 - X) * Y, X * Y},
            {-a * (1 - Y), a * (1 - Y), -a * Y, a * Y},
            {-b * (1 - X), -b * X, b * (1 - X), b * X}};
  }

  void scatter(const Particle& p) {
    const Weights near = weights(p);
    const double volume = p.mass / p.density;
    for (int k = 0; k < 4; ++k) {
      Node& node = nodes_[near.node[k]];
      const double mass = near.value[k] * p.mass;
      node.mass += mass;
      node.px += mass * p.vx;
      node.py += mass * p.vy;
      node.fx += mass * flow_.force.x() - volume * (p.stress.xx * near.slope_x[k] + p.stress.xy * near.slope_y[k]);
      node.fy += mass * flow_.force.y() - volume * (p.stress.xy * near.slope_x[k] + p.stress.yy * near.slope_y[k]);
    }
  }

  void accelerate(Node& node) const {
    if (node.mass == 0) return;
    node.ax = node.fx / node.mass;
    node.ay = node.fy / node.mass;
    node.vx = node.px / node.mass + dt_ * node.ax;
    node.vy = node.py / node.mass + dt_ * node.ay;
    node.px = node.py = 0;
  }

  /// Velocity by its increment (FLIP), and back to the nodes with it.
  void change_velocity(Particle& p) {
    const Weights near = weights(p);
    double ax = 0, ay = 0;
    for (int k = 0; k < 4; ++k) {
      ax += near.value[k] * nodes_[near.node[k]].ax;
      ay += near.value[k] * nodes_[near.node[k]].ay;
    }
    p.vx += dt_ * ax;
    p.vy += dt_ * ay;
    for (int k = 0; k < 4; ++k) {
      Node& node = nodes_[near.node[k]];
      const double mass = near.value[k] * p.mass;
      node.px += mass * p.vx;
      node.py += mass * p.vy;
    }
  }

  static void remap(Node& node) {
    if (node.mass == 0) return;
    node.later_x = node.px / node.mass;
    node.later_y = node.py / node.mass;
  }

  void move_and_strain(Particle& p) const {
    const Weights near = weights(p);
    double vx = 0, vy = 0, xx = 0, xy = 0, yx = 0, yy = 0;
    for (int k = 0; k < 4; ++k) {
      const Node& node = nodes_[near.node[k]];
      vx += near.value[k] * node.vx;
      vy += near.value[k] * node.vy;
      xx += near.slope_x[k] * node.later_x;
      xy += near.slope_y[k] * node.later_x;
      yx += near.slope_x[k] * node.later_y;
      yy += near.slope_y[k] * node.later_y;
    }
    p.x = grid_.wrapped(p.x + dt_ * vx);
    p.y += dt_ * vy;
    p.density /= 1 + dt_ * (xx + yy);
    p.stress = flow_.stress(p.density, xx, xy, yx, yy);
  }

  /// Walls at rest: their nodes neither move nor accelerate.
  void hold() {
    for (int node : grid_.held(0)) nodes_[node].vx = nodes_[node].ax = nodes_[node].later_x = 0;
    for (int node : grid_.held(1)) nodes_[node].vy = nodes_[node].ay = nodes_[node].later_y = 0;
  }
};

}  // namespace touchstone::bench
