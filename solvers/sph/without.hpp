#pragma once
/// What a method does by default and can be made without, named by type: `Without<Repulsion>`. What is left out is not
/// compiled.

#include <type_traits>

namespace touchstone::sph {

struct DensityReinitialisation {};  // printed: density reinitialised every 30 steps (29), (30)
struct Repulsion {};                // printed: particles on the walls that push
struct VolumeConstraint {};         // transport velocity: the particles' volumes add up to that of the fluid
struct BackgroundPressure {};       // transport velocity: the background pressure, and with it all drift
struct DriftMomentum {};            // transport velocity: what the drift of particles carries of momentum

template <class... Parts>
struct Without {
  template <class Part>
  static constexpr bool keeps = !(std::is_same_v<Part, Parts> || ...);
};

}  // namespace touchstone::sph
