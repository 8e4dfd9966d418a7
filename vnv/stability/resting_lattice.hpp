#pragma once
/// Fluid at rest on a square lattice that repeats along both axes: where a method has no walls, no surface and no flow,
/// and linear theory knows all.

#include "solvers/fluids/newtonian.hpp"
#include "vnv/case.hpp"

namespace touchstone::vnv {

/// Unit cells of the lattice are alike: for the material point method those of the background grid, with some particles
/// in each, otherwise those of one particle.
struct RestingLattice {
  int cells = 8;              // along each side
  int points = 1;             // particles across a unit cell
  Vec2 shift = Vec2::Zero();  // of all particles, in spacings, from where they stand evenly in their cells
  double smoothing = 0;       // spacings  the smoothing length; 0: that of the method
  double reynolds = 1e9;      // -  spacing times speed of sound over kinematic viscosity
  double pressure = 0;        // of rho0 c²  that the fluid is under

  static constexpr double spacing = 0.01, density = 1000, sound_speed = 10;  // m, kg/m³, m/s

  double unit() const { return points * spacing; }                                 // m  side of a unit cell
  double side() const { return cells * unit(); }                                   // m
  int across() const { return cells * points; }                                    // particles along a side
  double kinematic_viscosity() const { return sound_speed * spacing / reynolds; }  // m²/s
  long particles() const { return static_cast<long>(across()) * across(); }
  /// As a level of the nightly suite: its spacing and its cell or smoothing length [m].
  Level level(std::string name = {}, bool in_acceptance = false) const {
    return {.name = std::move(name),
            .spacing = spacing,
            .cell = unit(),
            .smoothing_length = smoothing > 0 ? smoothing * spacing : not_a_number,
            .acceptance = in_acceptance ? 1.0 : 0.0,
            .nightly = 1};
  }
  /// The scene that starts so; `start.places` moves particles from their lattice, shifted already.
  template <class Force = NoForce>
  Scene<Newtonian, Force> scene(Start start = {}, const Force& body_force = {}) const {
    const double c = sound_speed;
    const auto moved = start.places;
    start.places = [moved, by = Vec2(shift * spacing)](const Vectors& lattice) -> Vectors {
      const Vectors shifted = lattice.colwise() + by;
      return moved ? moved(shifted) : shifted;
    };
    if (pressure != 0)
      start.pressure = [above = start.pressure, p = pressure * density * c * c](const Vec2& x) {
        return p + (above ? above(x) : 0);
      };
    return {.domain = {.box = {.high = {side(), side()}}, .periodic_x = true, .periodic_y = true},
            .fluid = {{.density = density, .bulk_modulus = density * c * c / Newtonian::gamma},
                      density * c * spacing / reynolds},
            .filled = {.high = {side(), side()}},
            .body_force = body_force,
            .start = start};
  }
};

/// A method on such a lattice; only its solver is asked for.
using OnLattice = std::function<Method(const RestingLattice&, const Start&)>;

/// A simulation of it, in steps in which sound travels `courant` unit cells.
inline Simulation simulate(const OnLattice& method, const RestingLattice& lattice, const Start& start, double courant) {
  return method(lattice, start).solver(lattice.level(), courant * lattice.unit() / RestingLattice::sound_speed);
}

}  // namespace touchstone::vnv
