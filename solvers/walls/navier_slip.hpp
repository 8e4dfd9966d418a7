#pragma once
#include "solvers/lattice.hpp"

namespace touchstone {

/// The fluid slides along a wall at rest in proportion to its shear there, v_t = b dv_t/dn with a slip length b [m],
/// and does not cross it (Navier 1823). Between the wall and where it is evaluated the velocity is taken as linear.
/// Throws std::invalid_argument for a length that is not positive: at 0 a wall is `no_slip`, at infinity `free_slip`.
inline WallVelocity navier_slip(double slip_length) {
  require_positive("navier_slip", "slip length [m]", slip_length);
  return [b = slip_length](const NearWall& fluid) -> Vec2 {
    return b / (b + fluid.distance) * (fluid.v - fluid.v.dot(fluid.n) * fluid.n);
  };
}

}  // namespace touchstone
