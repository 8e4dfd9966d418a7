/// The largest stable time step of each method in Poiseuille flow, compared with the Courant limit (31) of Sun et al.

#include "solvers/forces/force_field.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channel.hpp"
#include "vnv/stability/critical_step.hpp"

#include <numbers>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

/// The body force of the channel with a perturbation of 1e-3 at wavelengths of a few cells: without it nothing would
/// excite the acoustics of a lattice that is perfectly even.
struct StirredDrive {
  Vec2 operator()(const Vec2& x, double /*time*/) const {
    constexpr double F = 8 * mm, turn = 2 * std::numbers::pi;
    const double wave = std::sin(turn * (5 * x.x() / L + 11 * x.y() / H));
    return Vec2(F, 0) + 1e-3 * F * wave * Vec2(1, 1);
  }
};

const Scene<Newtonian, ForceField> scene{
    .domain = {.box = gap, .periodic_x = true},
    .fluid = water,
    .filled = gap,
    .walls = {floor_at(0, no_slip()), ceiling_at(H, no_slip())},
    .body_force = {StirredDrive{}},
};

/// The steady flow reaches 1 mm/s; at ten times that the run counts as diverged.
const StepSearch search{.low = 0.5 * us, .high = 200 * us, .speed_limit = 10 * mm};

const Claim courant = at_least(over_courant, 1, literature("Sun et al. (31): stable up to it"));
const Tolerance one_bisection{0.015, "different rounding may change the last bisection step"};
const Claim morris = at_least(over_courant, 0.25, literature("Morris, Fox & Zhu 1997: 0.25 h / c is stable"));
const Claim papers_step = at_least(stable_end, 5, literature("Sun et al. run every model with 5 us"));

constexpr double output_interval = 0.05;  // s  of which the steps that methods choose divide

/// Searches with a solver of the channels; (31) is that of a cell, or of so many spacings.
template <class MakeSolver>
auto searching(MakeSolver solver, double spacings = 0) {
  return [=](const Level& level, const Schedule&) {
    return search_critical_step([&](double time_step) { return solver(scene, level, time_step); }, search,
                                spacings > 0 ? spacings * level.spacing : level.cell, water.sound_speed());
  };
}

constexpr bool nightly_alone = true;
Level level_of_mpm(const std::string& name, double spacing, bool in_nightly_alone = false) {
  const double others = in_nightly_alone ? 0 : 1;
  return {.name = name, .spacing = spacing, .cell = H / 40, .acceptance = others, .report = others, .nightly = 1};
}
Level level_of_sph(const std::string& name, double spacing, bool in_nightly_alone = false) {
  const double others = in_nightly_alone ? 0 : 1;
  return {.name = name, .spacing = spacing, .acceptance = name == "S1" ? others : 0, .report = others, .nightly = 1};
}

/// A method that chooses its step itself; in MPM with four particles in a cell.
Method limits_of(Method method) {
  const auto solver = method.solver;
  const bool has_cells = method.name.starts_with("mpm");
  method.run = [=](const Level& level, const Schedule&) {
    return search_critical_step([&](double time_step) { return solver(level, time_step); }, search,
                                has_cells ? level.cell : level.spacing, water.sound_speed());
  };
  method.levels = {
      {.name = "40 across", .spacing = H / 40, .cell = H / 20, .acceptance = 1, .report = 1, .nightly = 1}};
  method.claims = {papers_step, at_least(stable_end, method.time_step(method.levels[0]) / us,
                                         theory("the time step that a method chooses is stable"))};
  method.tolerance = one_bisection;
  return method;
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Largest stable time step",
      .description =
          "Each method runs Poiseuille flow from rest, perturbed by waves of a thousandth of the body force, with steps "
          "found by bisection, 2000 steps each. A trial is unstable when a particle reaches ten times the "
          "steady velocity, leaves the domain or becomes NaN. (31) of Sun et al. is the cell size (MPM) or smoothing length "
          "(SPH) over the sound speed at rest.",
      .times = {1},
      .measurements = {},
      .methods = {{
                      .name = "mpm",
                      .description = mpm_words + moving_words,
                      .run = searching([](const auto&... of) { return mpm_solver<mpm::PrescribedMotion>(of...); }),
                      .levels = {level_of_mpm("M1", H / 40), level_of_mpm("M2", H / 80)},
                      .claims = {courant, papers_step},
                      .tolerance = one_bisection,
                  },
                  {
                      .name = "mpm_reset",
                      .description = mpm_words + reset_words,
                      .run = searching([](const auto&... of) { return mpm_solver<mpm::VelocityReset>(of...); }),
                      .levels = {level_of_mpm("M1", H / 40, nightly_alone), level_of_mpm("M2", H / 80, nightly_alone)},
                      .claims = {courant, papers_step},
                      .tolerance = one_bisection,
                  },
                  {
                      .name = "sph",
                      .description = sph_printed_words + conservative_words,
                      .run = searching([](const auto&... of) { return sph_printed_solver<>(of...); }, 1.2),
                      .levels = {level_of_sph("S1", H / 40), level_of_sph("S2", H / 80)},
                      .claims = {morris, papers_step},
                      .tolerance = one_bisection,
                  },
                  {
                      .name = "sph_difference",
                      .description = sph_printed_words + difference_words,
                      .run = searching(
                          [](const auto&... of) { return sph_printed_solver<sph::PressureDifference>(of...); }, 1.2),
                      .levels = {level_of_sph("S1", H / 40, nightly_alone)},
                      .claims = {morris, papers_step},
                      .tolerance = one_bisection,
                  },
                  {
                      .name = "sph_regularised",
                      .description = sph_regularised_words,
                      .run = searching([](const auto&... of) { return sph_regularised_solver<>(of...); }, 1),
                      .levels = {level_of_sph("S1", H / 40), level_of_sph("S2", H / 80)},
                      .claims = {morris, papers_step},
                      .tolerance = one_bisection,
                  },
                  {
                      .name = "sph_one_evaluation",
                      .description = sph_regularised_words + one_evaluation_words,
                      .run =
                          searching([](const auto&... of) { return sph_regularised_solver<AdamsBashforth>(of...); }, 1),
                      .levels = {level_of_sph("S1", H / 40, nightly_alone)},
                      .claims = {morris, papers_step},
                      .tolerance = one_bisection,
                  },
                  limits_of(vnv::mpm_affine(scene, output_interval)),
                  limits_of(vnv::mpm_least_squares(scene, output_interval)),
                  limits_of(vnv::sph_second_order(scene, output_interval))},
      .label = "stability",
  };
}
