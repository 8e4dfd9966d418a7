#pragma once
#include "solvers/fields.hpp"

namespace touchstone {

/// What contact with walls has done to a fluid since the start.
struct Contacts {
  long particles = 0;           // how often one was held, once a step and wall
  Vec2 impulse = Vec2::Zero();  // N s/m  that the fluid was given
  double energy = 0;            // J/m    of motion that it lost

  /// One particle whose velocity into the fluid, along a normal, was changed.
  void add(double mass, const Vec2& normal, double before, double after) {
    ++particles;
    impulse += mass * (after - before) * normal;
    energy += mass / 2 * (before * before - after * after);
  }
};

}  // namespace touchstone
