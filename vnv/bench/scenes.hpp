#pragma once
/// The flows of Sun et al. as they are timed, in any size.

#include "solvers/fluids/newtonian.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/scene.hpp"
#include "solvers/walls/free_slip.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/flow.hpp"

namespace touchstone::bench {

// Table 1.
inline constexpr double channel_length = 0.5 * mm, channel_height = 1 * mm, channel_drive = 8 * mm;  // m, m/s²
inline constexpr double channel_cell = 0.025 * mm, channel_step = 5 * us;

/// Poiseuille flow in a channel of any length and height [m]; without a height, that of the paper.
inline Scene<Newtonian, Uniform> channel(double length = channel_length, double height = channel_height) {
  return {.domain = {.box = {.high = {length, height}}, .periodic_x = true},
          .fluid = {{.density = 1000, .bulk_modulus = 143}, 1e-3},
          .filled = {.high = {length, height}},
          .walls = {floor_at(0, no_slip()), ceiling_at(height, no_slip())},
          .body_force = {{channel_drive, 0}}};
}

// Section 3.3; cells fit this tank exactly.
inline const Vec2 dam_tank{1.6, 1.2};  // m
inline constexpr double dam_cell = 0.02, dam_mpm_step = 50 * us, dam_sph_step = 25 * us;

/// The column of 0.6 m square in a tank of any size [m].
inline Scene<Tait, Uniform> dam(const Vec2& tank = dam_tank) {
  return {.domain = {.box = {.high = tank}},
          .fluid = {.density = 1000, .bulk_modulus = 0.36 * MPa},
          .filled = {.high = {0.6, 0.6}},
          .walls = {floor_at(0, free_slip()), left_at(0, free_slip()), right_at(tank.x(), free_slip())},
          .body_force = {{0, -9.8}}};
}

/// A square of vortices, without the force of the manufactured flow: its evaluation is not the method's.
inline const Scene<Newtonian>& vortices() {
  static const Scene<Newtonian> scene = [] {
    vnv::Flow flow = vnv::flow_named("manufactured");
    flow.drive = {};
    return vnv::scene_of<>(flow);
  }();
  return scene;
}

}  // namespace touchstone::bench
