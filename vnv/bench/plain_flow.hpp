#pragma once
/// What the plain loops of this folder are told of a flow. They are what the solvers are timed against: clear scalar
/// C++ on an array of structures, as a textbook has it (with a vector library's small vectors they take twice as long),
/// and nothing shared with the solvers but lattice and vectors.

#include "solvers/lattice.hpp"

namespace touchstone::bench {

/// Pa
struct PlainStress {
  double xx = 0, yy = 0, xy = 0;
};

/// A slightly compressible fluid, at rest at the start, in a rectangle that begins at the origin. A channel is periodic
/// along x between plates that the fluid sticks to; a tank has four walls that it slides along.
struct PlainFlow {
  enum class Shape { channel, tank };

  Shape shape;
  Vec2 size;            // m
  Vec2 filled;          // m      from the origin
  double density;       // kg/m³  at rest
  double bulk_modulus;  // Pa     K of Tait's law
  double viscosity;     // Pa s
  Vec2 force;           // m/s²   per mass

  /// Tait's law (33) of Sun et al. [Pa], without `pow`.
  double pressure(double rho) const {
    const double z = rho / density, z3 = z * z * z;
    return bulk_modulus * (z3 * z3 * z - 1);
  }
  /// Newtonian stress (32) of Sun et al. from the velocity gradient, v_x,x first.
  PlainStress stress(double rho, double xx, double xy, double yx, double yy) const {
    const double mean = -2.0 / 3 * viscosity * (xx + yy) - pressure(rho);
    return {2 * viscosity * xx + mean, 2 * viscosity * yy + mean, viscosity * (xy + yx)};
  }
  Lattice lattice(double spacing) const { return touchstone::lattice({.high = filled}, spacing, {.high = size}); }
};

/// The channel and the column of Sun et al., tables 1 and 2, sections 3.1 and 3.3.
inline const PlainFlow plain_channel{.shape = PlainFlow::Shape::channel,
                                     .size = {0.5 * mm, 1 * mm},
                                     .filled = {0.5 * mm, 1 * mm},
                                     .density = 1000,
                                     .bulk_modulus = 143,
                                     .viscosity = 1e-3,
                                     .force = {8 * mm, 0}};
inline const PlainFlow plain_dam{.shape = PlainFlow::Shape::tank,
                                 .size = {1.61, 1.2},
                                 .filled = {0.6, 0.6},
                                 .density = 1000,
                                 .bulk_modulus = 0.36 * MPa,
                                 .viscosity = 0,
                                 .force = {0, -9.8}};

}  // namespace touchstone::bench
