#pragma once
/// What the particles of a simulation keep to as long as it is one of a slightly compressible fluid. Beyond it numbers
/// mean nothing, however finite they are.

#include "vnv/run/simulation.hpp"

namespace touchstone::vnv {

/// Knows the start of a run, and refuses what cannot have come of it. Its limits are far outside of what a method may
/// be asked for, and say so of nothing that could still be right: a fluid that is slightly compressible moves at a
/// fraction of the speed of sound and keeps its density within some per cent.
class StateCheck {
 public:
  static constexpr double fastest = 5;                                  // speeds of sound
  static constexpr double least_density = 1e-2, greatest_density = 10;  // densities at rest
  static constexpr double most_energy = 4;  // kinetic, of what it is when all move at the speed of sound

  StateCheck(const Medium& medium, const Samples& at_start);

  /// Throws Diverged for the first particle with a place, velocity or density that is no number or outside its limits,
  /// and for a fluid that has lost or gained particles, mass or too much energy; then the particle is the fastest.
  void require(const Samples& samples, long step) const;

 private:
  Medium medium_;
  Eigen::Index particles_;
  double mass_;  // kg/m
};

}  // namespace touchstone::vnv
