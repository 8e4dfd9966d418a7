#pragma once
/// The front of a dam break: what is followed, how it is compared with the experiment, and how it is drawn.

#include "vnv/case.hpp"
#include "vnv/flows/front_comparison.hpp"
#include "vnv/measures/front.hpp"

namespace touchstone::vnv {

/// A column of water at the left end of a tank, and how its front is read.
struct DamFront {
  double column_length, column_height;  // m  l0, h0
  double tank_length, tank_height;      // m
  double density;                       // kg/m³
  double gravity;                       // m/s²
  double slab;                          // m  side of the slab that has to be half full

  // Quantities of the comparison with Lobovský et al. (2014).
  inline static const std::string rms = "RMS of L over T in [1, 1.5], no shift [-]";
  inline static const std::string slope_error =
      "slope dL/dT from T = 1 to 1.58 or the wall, less the measured 1.34 [%]";

  double scaled_time(double t) const { return t * std::sqrt(gravity * column_height) / column_length; }  // (39)

  /// The three fronts as L (38), half-full slab first, then 99.5th percentile, then farthest particle; then the mass
  /// [kg/m] and the number of particles in the tank.
  std::vector<double> look(const Samples& samples) const;

  /// Fronts against the measured one, mass and number of particles, of a run that was watched by `look`.
  std::vector<Error> compare(const Level& level, const Run& run) const;

  /// L over T for the levels named, with Lobovský et al., Martin & Moyce and Ritter's bound.
  Plot history(Figure frame, std::vector<std::string> levels) const;

  /// Table 5 of Sun et al. beside ours, with time per step and memory.
  Plot models() const;
};

}  // namespace touchstone::vnv
