/// The largest stable time step of each method in Poiseuille flow, compared with the Courant limit (31) of Sun et al.

#include "vnv/flows/channels/driven_channel.hpp"
#include "vnv/stability/critical_step.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::channel;

namespace {

const Scene<Newtonian, ForceField> scene = driven_by(perturbed_drive(1e-3));

const StepSearch search{.low = 0.5 * us, .high = 200 * us, .speed_limit = too_fast};

const Claim courant = at_least(over_courant, 1, literature("Sun et al. (31): stable up to it"));
const Tolerance one_bisection{0.015, "different rounding may change the last bisection step"};
const Claim morris = at_least(over_courant, 0.25, literature("Morris, Fox & Zhu 1997: 0.25 h / c is stable"));
const Claim papers_step = at_least(stable_end, 5, literature("Sun et al. run every model with 5 us"));

constexpr double output_interval = 0.05;  // s  of which the steps that methods choose divide

/// (31) is that of a cell, or of so many spacings.
Method searching(Method method, double spacings = 0) {
  method.run = [=, solver = method.solver](const Level& level, const Schedule&) {
    return search_critical_step([&](double time_step) { return solver(level, time_step); }, search,
                                spacings > 0 ? spacings * level.spacing : level.cell, water.sound_speed());
  };
  method.tolerance = one_bisection;
  return method;
}

enum class Suites { all, all_but_acceptance, nightly_alone };
Level level(const std::string& name, double spacing, Suites suites, double cell = not_a_number) {
  const double by_day = suites == Suites::all ? 1 : 0, reported = suites == Suites::nightly_alone ? 0 : 1;
  return {.name = name, .spacing = spacing, .cell = cell, .acceptance = by_day, .report = reported, .nightly = 1};
}

/// A method that takes the paper's step, on levels of MPM or, with a smoothing length of so many spacings, of SPH.
Method of_paper(const std::string& name, const std::string& words,
                Simulation (*solver)(const Scene<Newtonian, ForceField>&, const Level&, double), Suites suites,
                double spacings = 0) {
  Method method{.name = name,
                .description = words,
                .solver = [=](const Level& at, double time_step) { return solver(scene, at, time_step); },
                .claims = {spacings > 0 ? morris : courant, papers_step}};
  if (spacings == 0)
    method.levels = {level("M1", H / 40, suites, H / 40), level("M2", H / 80, suites, H / 40)};
  else
    method.levels = {level("S1", H / 40, suites)};
  if (spacings > 0 && suites == Suites::all) method.levels.push_back(level("S2", H / 80, Suites::all_but_acceptance));
  return searching(std::move(method), spacings);
}

/// A method that chooses its step itself; in MPM with four particles in a cell.
Method limits_of(Method method) {
  method.levels = {level("40 across", H / 40, Suites::all, H / 20)};
  method.claims = {papers_step, at_least(stable_end, method.time_step(method.levels[0]) / us,
                                         theory("the time step that a method chooses is stable"))};
  return searching(method, method.family == Family::mpm ? 0 : 1);
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Largest stable time step",
      .description =
          "Each method runs Poiseuille flow from rest, perturbed by waves of a thousandth of the body force, with steps "
          "found by bisection, 2000 steps each. A trial is unstable when a particle reaches ten times the "
          "steady velocity, leaves the domain or becomes NaN. The limit (31) of Sun et al. is the cell size (MPM) or "
          "smoothing length (SPH) over the sound speed at rest.",
      .times = {1},
      .measurements = {},
      .methods = {of_paper("mpm", mpm_words + moving_words, mpm_solver<mpm::PrescribedMotion>, Suites::all),
                  of_paper("mpm_reset", mpm_words + reset_words, mpm_solver<mpm::VelocityReset>, Suites::nightly_alone),
                  of_paper("sph", sph_printed_words + conservative_words, sph_printed_solver<>, Suites::all, 1.2),
                  of_paper("sph_difference", sph_printed_words + difference_words,
                           sph_printed_solver<sph::PressureDifference>, Suites::nightly_alone, 1.2),
                  of_paper("sph_regularised", sph_regularised_words, sph_regularised_solver<>, Suites::all, 1),
                  of_paper("sph_one_evaluation", sph_regularised_words + one_evaluation_words,
                           sph_regularised_solver<AdamsBashforth>, Suites::nightly_alone, 1),
                  limits_of(vnv::mpm_affine(scene, output_interval)),
                  limits_of(vnv::mpm_least_squares(scene, output_interval)),
                  limits_of(vnv::sph_second_order(scene, output_interval))},
      .label = "stability",
  };
}
