#pragma once
/// What a pressure sensor in an upright wall reads. The answer depends on the operator, and a computation of an impact
/// may differ by several times between two, so there are two: tell both.
///
/// Both read over the sensor's face the force by its area: where only a part of the face is wet, the rest counts as 0.
/// Both follow the spacing of the particles, as a face of a few millimetres may be smaller than it. Without water at
/// the face they read 0. For samples without particles, with a place or volume that is no finite number, or a pressure
/// near the sensor that is none, they give not a number.

#include "solvers/samples.hpp"

namespace touchstone::vnv {

/// A disc in a wall at x = `wall`, with the fluid at lesser x, above a floor at y = 0.
struct WallSensor {
  double wall;      // m
  double height;    // m  of its centre
  double diameter;  // m
};

/// The mean pressure [Pa] of what lies within 1.5 spacings of the wall, over the sensor's diameter or 1.5 spacings of
/// height, whichever is more. It reads half that far into the fluid; a patch that the floor cuts off reads in the
/// middle of the rest. Where the edges of a patch cut particles evenly, a hydrostatic pressure is read exactly, else to
/// a fraction of a spacing. Throws std::invalid_argument for lengths that are not positive.
double mean_wall_pressure(const Samples& samples, const WallSensor& sensor, double spacing);

/// The pressure [Pa] at the wall, by the affine function that fits those within 2.5 spacings of the sensor's face best,
/// in the middle of the wet part of its face: a mean over the face, as the function is affine. A hydrostatic pressure
/// is read exactly at any height, up to floor and surface. Throws std::invalid_argument for lengths that are not
/// positive.
double fitted_wall_pressure(const Samples& samples, const WallSensor& sensor, double spacing);

}  // namespace touchstone::vnv
