#pragma once
/// What the sources of this folder share: how a solver becomes a method, and the scenes for which it is compiled.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/fluids/tait.hpp"
#include "solvers/forces/force_field.hpp"
#include "solvers/forces/rolling.hpp"
#include "solvers/forces/skin_friction.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/scene.hpp"
#include "vnv/methods/methods.hpp"
#include "vnv/methods/setups.hpp"

#include <fmt/format.h>

namespace touchstone::vnv {

/// A solver as a method that keeps an acoustic Courant number c dt / length, by the level's cell in MPM and its spacing
/// in SPH; `method` has a name, a family and a description but for that number.
template <class AnyScene>
Method keeping_courant_number(double courant, double output_interval, const AnyScene& scene,
                              Simulation (*solver)(const AnyScene&, const Level&, double), Method method) {
  const bool has_grid = method.family == Family::mpm;
  const auto length = has_grid ? &Level::cell : &Level::spacing;
  method.description +=
      fmt::format(" Acoustic Courant number {:g}, based on the {}.", courant, has_grid ? "cell" : "spacing");
  method.tolerance = stretched;
  return simulating(
      std::move(method),
      [=](const Level& level, double time_step) { return solver(scene_at(level, scene), level, time_step); },
      [=](const Level& level) { return step_for(scene_at(level, scene), courant, level.*length, output_interval); });
}

}  // namespace touchstone::vnv

// `declare` gets each scene as its argument.
#define TOUCHSTONE_VISCOUS_SCENES(declare) \
  declare(Scene<Newtonian>) declare(Scene<Newtonian, Uniform>) declare(Scene<Newtonian, ForceField>)
#define TOUCHSTONE_SCENES(declare) TOUCHSTONE_VISCOUS_SCENES(declare) declare(Scene<Tait>) declare(Scene<Tait, Uniform>)
/// Those of the methods for free surfaces; the resting lattice has neither gravity nor surface.
#define TOUCHSTONE_FREE_SURFACE_SCENES(declare) \
  declare(Scene<Newtonian>) declare(Scene<Newtonian, Uniform>) declare(Scene<Tait>) declare(Scene<Tait, Uniform>)
