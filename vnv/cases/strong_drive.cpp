/// Poiseuille flow with a hundredfold body force, Reynolds number 100, Mach number 0.1.

#include "reference/poiseuille.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channel.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

constexpr double F = 800 * mm;  // m/s²
constexpr double end = 0.5;     // s

const Scene<Newtonian, Uniform> scene{
    .domain = {.box = gap, .periodic_x = true},
    .fluid = water,
    .filled = gap,
    .walls = {floor_at(0, no_slip()), ceiling_at(H, no_slip())},
    .body_force = {{F, 0}},
};

const reference::Poiseuille exact{.H = H, .F = F, .nu = water.kinematic_viscosity()};

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Poiseuille flow with a hundredfold body force",
      .description =
          "Poiseuille flow with a body force of 0.8 m/s², a hundred times the paper's: steady velocity 0.1 m/s, "
          "Reynolds number 100, Mach number 0.1. Expected: every method as accurate as with the paper's force; particle rows "
          "slide past each other at a hundred times the speed. The oracle is the exact series.",
      .times = {0.05, end},
      .measurements = {norms_of("v_x, row means", by_rows, exact), norms_of("v_x, per particle", by_particles, exact)},
      .methods =
          {{
               .name = "mpm",
               .description = mpm_words + moving_words,
               .run = mpm_with<mpm::PrescribedMotion>(scene),
               .levels = {{.name = "M1",
                           .spacing = H / 40,
                           .cell = H / 40,
                           .acceptance = end,
                           .report = end,
                           .nightly = end}},
               .claims = {at_most(l2_rows, 0.17, baseline("twice the error with the paper's bulk modulus and force"))},
           },
           {
               .name = "sph",
               .description = sph_printed_words + conservative_words,
               .run = channel::sph_as_printed(scene),
               .levels = {{.name = "S1", .spacing = H / 40, .acceptance = 0.05, .report = end, .nightly = end}},
               .claims = {at_most(l2_rows, 4.39, literature("Sun et al., table 3, S1, for the paper's force"))
                              .on("S1")
                              .at(end)},
               .tolerance = stretched,
           },
           {
               .name = "sph_regularised",
               .description = sph_regularised_words,
               .run = sph_with_transport_velocity(scene),
               .levels = {{.name = "S1", .spacing = H / 40, .acceptance = 0.05, .report = end, .nightly = end}},
               .claims = {at_most(l2_rows, 0.34, baseline("twice the error with the paper's bulk modulus and force"))},
               .tolerance = stretched,
           }},
      .plots = {profiles(
          {"profile", "Velocity profiles", "Row means at 800 particles.", {"y [mm]", 1e3}, {"v_x [mm/s]", 1e3}},
          by_rows, exact, H, {"M1", "S1"})},
  };
}
