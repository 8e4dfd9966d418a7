#pragma once
/// The methods as any flow may run them, whose steps follow from how far sound travels. `output_interval` [s] holds a
/// whole number of steps; a level that names its own step or kernel has them.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/fluids/tait.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/scene.hpp"
#include "vnv/methods/across.hpp"

namespace touchstone::vnv {

/// Flow that stretches its fluid, or whose rows slip past each other, doubles a rounding error every so often.
inline const Tolerance stretched{0.02, "tuned and portable builds differ by less"};

/// The scene with the sound speed and the period that a level names. Only the fluid and the length of its box change:
/// for scenes whose start and force do not follow from them.
template <class AnyScene>
AnyScene scene_at(const Level& level, AnyScene scene) {
  if (!std::isnan(level.sound_speed))
    scene.fluid.bulk_modulus = scene.fluid.density * level.sound_speed * level.sound_speed / Tait::gamma;
  if (!std::isnan(level.period))
    for (Box* box : {&scene.domain.box, &scene.filled}) box->high.x() = box->low.x() + level.period;
  return scene;
}

/// `courant` is the acoustic Courant number, c dt / cell in MPM and c dt / spacing in SPH.
Method mpm_as_printed(const auto& scene, double output_interval, double courant = 0.5);

/// Of viscous scenes, as printed but for the shape functions.
Method mpm_gimp(const auto& scene, double output_interval, double courant = 0.5);

Method mpm_affine(const auto& scene, double output_interval, double courant = 0.8);

/// For fluid that fills its domain.
Method mpm_least_squares(const auto& scene, double output_interval, double courant = 0.3);

Method sph_as_printed(const auto& scene, double output_interval, double courant = 0.25);

/// For fluid without a free surface.
Method sph_transport_velocity(const auto& scene, double output_interval, double courant = 0.25);

/// For fluid that fills its domain.
Method sph_second_order(const auto& scene, double output_interval, double courant = 0.3);

}  // namespace touchstone::vnv
