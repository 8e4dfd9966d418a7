#pragma once
#include "solvers/stepping/laps.hpp"

namespace touchstone::mpm {

/// The stress of a step is that of the velocities at its start (update stress first, USF; Bardenhagen, J. Comput. Phys.
/// 180 (2002), 383-403).
struct StressFirst {
  template <class Parts, class Laps>
  static void step(Parts& parts, const Laps& lap) {
    parts.scatter_momentum();
    parts.hold_start();
    lap(SubStep::scatter);
    parts.strain_and_stress();
    lap(SubStep::gather);
    parts.scatter_forces();
    lap(SubStep::scatter);
    parts.accelerate();
    lap(SubStep::grid);
    parts.gather_motion();
    lap(SubStep::gather);
  }
};

}  // namespace touchstone::mpm
