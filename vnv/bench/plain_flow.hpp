#pragma once
/// What the plain loops of this folder need to know of a flow. They are what the solvers are timed against: clear
/// scalar C++ on an array of structures, as a textbook has it (with a vector library's small vectors they take twice as
/// long), and nothing shared with the solvers but lattice and vectors.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/lattice.hpp"

#include <vector>

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

/// The particles of a flow at the start, which have place, mass [kg/m] and density.
template <class Particle>
std::vector<Particle> particles_at_rest(const PlainFlow& flow, double spacing) {
  const Lattice points = flow.lattice(spacing);
  std::vector<Particle> particles;
  for (const Vectors places = points.places(); const auto& x : places.colwise())
    particles.push_back({.x = x.x(), .y = x.y(), .mass = flow.density * points.volume(), .density = flow.density});
  return particles;
}

/// What a plain loop needs of a scene: no more than the flows of `scenes.hpp` have.
template <class FluidLaw>
PlainFlow plain(const Scene<FluidLaw, Uniform>& scene) {
  double viscosity = 0;
  if constexpr (Viscous<FluidLaw>) viscosity = scene.fluid.viscosity;
  return {.shape = scene.domain.periodic_x ? PlainFlow::Shape::channel : PlainFlow::Shape::tank,
          .size = scene.domain.box.high,
          .filled = scene.filled.high,
          .density = scene.fluid.density,
          .bulk_modulus = scene.fluid.bulk_modulus,
          .viscosity = viscosity,
          .force = scene.body_force.per_mass};
}

}  // namespace touchstone::bench
