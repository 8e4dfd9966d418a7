#pragma once
/// A square box whose lid slides over the fluid in it [Ghia, Ghia & Shin 1982].

#include "solvers/walls/no_slip.hpp"
#include "vnv/measures/centrelines.hpp"
#include "vnv/methods/methods.hpp"

namespace touchstone::vnv::lid_driven {

inline constexpr Cavity cavity{.side = 1, .lid_speed = 1};
inline constexpr double rho = 1000, c = 5;       // kg/m³, m/s
inline constexpr double output_interval = 0.25;  // s  holds a whole number of steps

/// At a Reynolds number; `lid` says which way it slides. Where walls meet the last one holds: the lid reaches from wall
/// to wall.
inline Scene<Newtonian> scene_at(double Re, const Vec2& lid = {cavity.lid_speed, 0}) {
  const Vec2 corner(cavity.side, cavity.side);
  return {.domain = {.box = {.high = corner}},
          .fluid = {{.density = rho, .bulk_modulus = rho * c * c / 7}, rho * cavity.lid_speed * cavity.side / Re},
          .filled = {.high = corner},
          .walls = {floor_at(0, no_slip()), left_at(0, no_slip()), right_at(cavity.side, no_slip()),
                    ceiling_at(cavity.side, no_slip(lid))}};
}

// The methods that run it, for a scene.
inline Method affine(const Scene<Newtonian>& scene) { return mpm_affine(scene, output_interval); }
inline Method least_squares(const Scene<Newtonian>& scene) { return mpm_least_squares(scene, output_interval, 0.5); }
inline Method second_order(const Scene<Newtonian>& scene) { return sph_second_order(scene, output_interval, 0.45); }

}  // namespace touchstone::vnv::lid_driven
