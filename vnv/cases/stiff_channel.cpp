/// Poiseuille flow of a fluid with a hundredfold bulk modulus: K x 100, sound ten times faster, the time step ten times
/// shorter.

#include "reference/poiseuille.hpp"
#include "solvers/forces/uniform.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channel.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

constexpr double F = 8 * mm;  // m/s²
constexpr double step = 0.5 * us, regularised_step = 1 * us;
constexpr double end = 0.05;  // s

const Scene<Newtonian, Uniform> scene{
    .domain = {.box = gap, .periodic_x = true},
    .fluid = {{.density = 1000, .bulk_modulus = 14300}, 1e-3},
    .filled = gap,
    .walls = {floor_at(0, no_slip()), ceiling_at(H, no_slip())},
    .body_force = {{F, 0}},
};

const reference::Poiseuille exact{.H = H, .F = F, .nu = water.kinematic_viscosity()};

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Poiseuille flow with a hundredfold bulk modulus",
      .description =
          "Poiseuille flow with K = 14.3 kPa, a hundred times the paper's: the sound speed is 10 m/s, the Mach number "
          "1e-4, the time step 0.5 us. Expected: MPM and regularised SPH as accurate as with the paper's bulk modulus, SPH as printed stable "
          "but inaccurate. The oracle is the exact series.",
      .times = {end},
      .measurements = {norms_of("v_x, row means", by_rows, exact), norms_of("v_x, per particle", by_particles, exact)},
      .methods =
          {{
               .name = "mpm",
               .description = mpm_words + moving_words,
               .run = mpm_with<mpm::PrescribedMotion>(scene, step),
               .levels = {{.name = "M1",
                           .spacing = H / 40,
                           .cell = H / 40,
                           .acceptance = end,
                           .report = end,
                           .nightly = end}},
               .claims = {at_most(l2_rows, 0.25, baseline("twice the error with the paper's bulk modulus and force"))},
           },
           {
               .name = "sph",
               .description = sph_printed_words + conservative_words,
               .run = channel::sph_as_printed(scene, step),
               .levels = {{.name = "S1", .spacing = H / 40, .acceptance = end, .report = end, .nightly = end}},
               .tolerance = stretched,
           },
           {
               .name = "sph_regularised",
               .description = sph_regularised_words,
               .run = sph_with_transport_velocity(scene, regularised_step),
               .levels = {{.name = "S1", .spacing = H / 40, .acceptance = end, .report = end, .nightly = end}},
               .claims = {at_most(l2_rows, 0.3, baseline("twice the error with the paper's bulk modulus and force"))},
               .tolerance = stretched,
           }},
      .plots = {profiles(
          {"profile", "Velocity profiles", "Row means at 800 particles.", {"y [mm]", 1e3}, {"v_x [mm/s]", 1e3}},
          by_rows, exact, H, {"M1", "S1"})},
  };
}
