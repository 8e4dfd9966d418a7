#pragma once
/// A scene is a value: all of the physics of one problem, in SI units, and nothing else.
/// Spacing, kernel, cell, time step and artificial viscosity belong to a method.

#include "solvers/fields.hpp"
#include "solvers/forces/none.hpp"
#include "solvers/walls/wall.hpp"

#include <cmath>
#include <functional>
#include <vector>

namespace touchstone {

/// An upright rectangle.
struct Box {
  Vec2 low = Vec2::Zero();  // m
  Vec2 high;                // m

  Vec2 size() const { return high - low; }
  /// False for a place with a coordinate that is not a number.
  bool contains(const Vec2& x) const { return (x.array() >= low.array()).all() && (x.array() <= high.array()).all(); }
};

/// Where particles may be. A particle outside is lost, and a lost particle ends the run.
struct Domain {
  Box box;
  bool periodic_x = false;
  bool periodic_y = false;

  bool periodic(int axis) const { return axis == 0 ? periodic_x : periodic_y; }
  /// A coordinate [m], taken back into the box along a periodic axis.
  double wrapped(int axis, double x) const {
    if (!periodic(axis)) return x;
    const double low = box.low[axis], length = box.high[axis] - low;
    return x - length * std::floor((x - low) / length);
  }
};

/// How the fluid is when the run starts: at rest, without pressure, and on a lattice, where nothing is said.
struct Start {
  std::function<Vec2(const Vec2&)> velocity{};    // m/s  at a place [m]
  std::function<double(const Vec2&)> pressure{};  // Pa
  /// Where the particles stand [m], from the lattice in the filled box: disturbed, numbered anew, or only those within
  /// a drop.
  std::function<Vectors(const Vectors&)> places{};

  bool at_rest() const { return !velocity && !pressure; }
  Vec2 velocity_at(const Vec2& x) const { return velocity ? velocity(x) : Vec2(Vec2::Zero()); }
  double pressure_at(const Vec2& x) const { return pressure ? pressure(x) : 0; }
  Vectors places_on(const Vectors& lattice) const { return places ? places(lattice) : lattice; }
};

/// What is named by its type is in the scene; what is not named is not there and is not compiled: a scene
/// `Scene<Tait>` has neither viscosity nor body force, `Scene<Newtonian, Uniform>` has both.
template <class FluidLaw, class Force = NoForce>
struct Scene {
  Domain domain;
  FluidLaw fluid;
  Box filled;
  std::vector<Wall> walls{};
  Force body_force{};
  Start start{};
};

}  // namespace touchstone
