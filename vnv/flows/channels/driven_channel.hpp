#pragma once
/// Plane Poiseuille flow of water by any body force, between the plates of Sun et al. at rest.

#include "solvers/forces/force_field.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channels/channel.hpp"
#include "vnv/flows/flow.hpp"

#include <numbers>

namespace touchstone::vnv::channel {

template <class Force>
Scene<Newtonian, Force> driven_by(const Force& body_force) {
  return {.domain = {.box = gap, .periodic_x = true},
          .fluid = water,
          .filled = gap,
          .walls = {floor_at(0, no_slip()), ceiling_at(H, no_slip())},
          .body_force = body_force};
}

/// The paper's body force with a perturbation, a fraction of it, at wavelengths of a few cells: without it nothing
/// would excite the acoustics of a lattice that is perfectly even.
inline ForceField perturbed_drive(double fraction) {
  return {[=](const Vec2& x, double /*time*/) -> Vec2 {
    const double wave = std::sin(2 * std::numbers::pi * (5 * x.x() / L + 11 * x.y() / H));
    return Vec2(drive, 0) + fraction * drive * wave * Vec2(1, 1);
  }};
}

/// The steady flow of the paper reaches 1 mm/s; at ten times that a run counts as diverged.
inline constexpr double too_fast = 10 * mm;  // m/s

/// Three methods at 40 particles across in a channel that is not the paper's, with steps [s] of the first two and of
/// the third: acceptance runs SPH up to the first of the times.
inline Case forty_across(const Flow& flow, const std::vector<double>& times, double step, double step_of_regularised) {
  const double end = times.back();
  const auto scene = scene_of<Newtonian, Uniform>(flow);
  const Truth exact = flow.along_x();
  const Level of_sph{.name = "S1", .spacing = H / 40, .acceptance = times.front(), .report = end, .nightly = end};
  return {
      .times = times,
      .measurements = {norms_of("v_x, row means", by_rows, exact), norms_of("v_x, per particle", by_particles, exact)},
      .methods =
          {{.name = "mpm",
            .family = Family::mpm,
            .description = mpm_words + moving_words,
            .run = mpm_with<mpm::PrescribedMotion>(scene, step),
            .levels =
                {{.name = "M1", .spacing = H / 40, .cell = H / 40, .acceptance = end, .report = end, .nightly = end}}},
           {.name = "sph",
            .family = Family::sph,
            .description = sph_printed_words + conservative_words,
            .run = channel::sph_as_printed(scene, step),
            .levels = {of_sph},
            .tolerance = stretched},
           {.name = "sph_regularised",
            .family = Family::sph,
            .description = sph_regularised_words,
            .run = sph_with_transport_velocity(scene, step_of_regularised),
            .levels = {of_sph},
            .tolerance = stretched}},
      .plots = {profiles(
          {"profile", "Velocity profiles", "Row means at 800 particles.", {"y [mm]", 1e3}, {"v_x [mm/s]", 1e3}},
          by_rows, exact, H, {"M1", "S1"})},
      .priced_as = "poiseuille_run_time",
  };
}

}  // namespace touchstone::vnv::channel
