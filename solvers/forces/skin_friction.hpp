#pragma once
/// Gravity, and the skin friction of a tank that a plane flow does not have: of its side walls, a breadth apart, and of
/// its floor at y = 0, neither of whose boundary layers is resolved.

#include "solvers/fields.hpp"

#include <cmath>

namespace touchstone {

/// Each wall bears c_f rho |v| v / 2, with v as it is beside it (Schlichting, Boundary-Layer Theory, ch. 21, gives c_f
/// over the Reynolds number). The floor's part is shared by the water in a layer that is thin beside the flow.
struct SkinFriction {
  Vec2 gravity = Vec2::Zero();  // m/s²
  double coefficient;           // -   c_f
  double layer;                 // m   above the floor
  double breadth = INFINITY;    // m   of the tank, between its side walls

  Vec2 operator()(const Vec2& x, double /*time*/, const Vec2& v) const {
    const double per_length = 2 / breadth + (x.y() < layer ? 1 / layer : 0);  // 1/m  wetted area over volume
    return gravity - 0.5 * coefficient * per_length * v.norm() * v;
  }
};

}  // namespace touchstone
