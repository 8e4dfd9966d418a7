#pragma once
/// The scenes for which solvers are compiled, for the sources of this folder: `declare` gets each as its argument.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/fluids/tait.hpp"
#include "solvers/forces/force_field.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/scene.hpp"

#define TOUCHSTONE_VISCOUS_SCENES(declare) \
  declare(Scene<Newtonian>) declare(Scene<Newtonian, Uniform>) declare(Scene<Newtonian, ForceField>)
#define TOUCHSTONE_INVISCID_SCENES(declare) declare(Scene<Tait>) declare(Scene<Tait, Uniform>)
/// Those of the methods for free surfaces; the resting lattice has neither gravity nor surface.
#define TOUCHSTONE_FREE_SURFACE_SCENES(declare) \
  declare(Scene<Newtonian>) declare(Scene<Newtonian, Uniform>) declare(Scene<Tait>) declare(Scene<Tait, Uniform>)
