#pragma once
/// A pair of particles as a term of the momentum equation sees it.
/// `Real` is a number, or several of them side by side (pair_lanes.hpp): terms have no branch.

#include "solvers/sph/pair_lanes.hpp"

namespace touchstone::sph {

/// Particle i and its neighbour j.
template <class Real>
struct Pair {
  Real x, y;          // m     r_i - r_j
  Real r2, r;         // m², m |r_i - r_j|² and its root
  Real slope;         // m⁻⁴   W'(r) / r, so that the gradient of W_ij at i is slope * (x, y)
  Real vx, vy;        // m/s   v_i - v_j
  Real rho_i, rho_j;  // kg/m³
  Real p_i, p_j;      // Pa
  Real specific_volume_i, specific_volume_j;  // m³/kg 1 / rho
  Real p_over_rho2_i, p_over_rho2_j;          // Pa m⁶/kg²  p / rho²
  NumberIn<Real> mass;                        // kg/m  of each

  Real v_dot_r() const { return x * vx + y * vy; }              // m²/s  v_ij · r_ij, negative when closing in
  Real continuity() const { return mass * slope * v_dot_r(); }  // kg/m³ s  what j adds to the rate of rho_i (23)
};

/// An acceleration [m/s²].
template <class Real>
struct Acceleration {
  Real x{}, y{};

  Acceleration& operator+=(const Acceleration& other) {
    x += other.x;
    y += other.y;
    return *this;
  }
};

}  // namespace touchstone::sph
