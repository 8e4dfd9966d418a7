#pragma once
#include "solvers/stepping/laps.hpp"

namespace touchstone::mpm {

/// The stress is found at the end of a step, by the velocities with which the nodes have moved (update stress last,
/// USL; Bardenhagen, J. Comput. Phys. 180 (2002), 383-403). Nodes of little mass at a free surface strain their
/// particles too much: with hats and PIC a dam break diverges.
struct StressLast {
  template <class Parts, class Laps>
  static void step(Parts& parts, const Laps& lap) {
    parts.scatter_momentum();
    parts.scatter_forces();
    lap(SubStep::scatter);
    parts.accelerate();
    lap(SubStep::grid);
    parts.gather_motion();
    parts.strain_and_stress();
    lap(SubStep::gather);
  }
};

}  // namespace touchstone::mpm
