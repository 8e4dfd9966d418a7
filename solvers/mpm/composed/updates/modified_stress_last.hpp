#pragma once
#include "solvers/stepping/laps.hpp"

namespace touchstone::mpm {

/// The stress is found at the end of a step, by velocities that the particles give to the nodes anew (modified update
/// stress last, MUSL; Sulsky, Zhou & Schreyer 1995): nodes of little mass, at a free surface, strain less.
struct ModifiedStressLast {
  template <class Parts, class Laps>
  static void step(Parts& parts, const Laps& lap) {
    parts.scatter_momentum();
    parts.scatter_forces();
    lap(SubStep::scatter);
    parts.accelerate();
    lap(SubStep::grid);
    parts.gather_motion();
    lap(SubStep::gather);
    parts.remap_velocity();
    lap(SubStep::grid);
    parts.strain_and_stress();
    lap(SubStep::gather);
  }
};

}  // namespace touchstone::mpm
