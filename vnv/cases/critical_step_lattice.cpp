/// The largest stable time step of each method on a lattice at rest, compared with its own linear stability theory.

#include "reference/leapfrog_sph.hpp"
#include "vnv/stability/critical_step.hpp"
#include "vnv/stability/lattice_starts.hpp"
#include "vnv/stability/parts_on_lattice.hpp"
#include "vnv/stability/spectrum.hpp"

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

// All relative to the unit cell: the background cell of MPM, the spacing of SPH.
const Quantity measured{"largest stable acoustic Courant number, measured", "", Kind::stability_limit},
    by_theory{"largest stable acoustic Courant number, linear theory", "", Kind::stability_limit},
    measured_over_theory{"largest stable time step, measured over linear theory", ""},
    measured_over_criterion{"largest stable time step, measured over the criterion of leapfrog", ""},
    growth_seen{"growth per step at 1.05 times the largest stable step, measured", "", Kind::value, Better::smaller},
    growth_by_theory{"growth per step at 1.05 times the largest stable step, linear theory", "", Kind::value,
                     Better::smaller},
    growth_over_theory{"log growth at 1.05 times the largest stable step, measured over linear theory", ""};

/// Kick-drift-kick of the quintic spline with h one spacing, without dissipation: for these a closed criterion holds.
bool is_leapfrog(const std::string& method) {
  return method == "sph_regularised" || method == "sph_transport_velocity";
}

/// A lattice, and which suites run it.
struct Arrangement {
  std::string name;
  RestingLattice lattice;
  bool in_acceptance = false;
};

std::vector<Arrangement> arrangements(const LatticeMethod& method) {
  const bool is_daily = !method.at_night_only;
  std::vector<Arrangement> all;
  if (!method.has_grid()) {
    all.push_back({"h of the method", {.cells = 12}, is_daily});
    if (method.one_kernel || method.at_night_only) return all;
    all.push_back({"h = 1.3 spacings", {.cells = 12, .smoothing = 1.3}});
    all.push_back({"h = 1.6 spacings", {.cells = 16, .smoothing = 1.6}});
    return all;
  }
  if (!method.fits) all.push_back({"1 per cell", {.cells = 8}, is_daily});
  all.push_back({"4 per cell", {.cells = 8, .points = 2}, is_daily});
  if (!method.fits && !method.at_night_only) {
    all.push_back({"9 per cell", {.cells = 6, .points = 3}});
    all.push_back({"1 per cell, a quarter off its middle", {.cells = 8, .shift = {0.25, 0.25}}});
    all.push_back({"4 per cell, a quarter of a spacing off", {.cells = 8, .points = 2, .shift = {0.25, 0.25}}});
  }
  return all;
}

Run compare(const LatticeMethod& method, const RestingLattice& lattice) {
  const CostMeter meter;
  const double c = RestingLattice::sound_speed, a_length = lattice.unit() / c;
  // Between speeds of a hundred-millionth and of a ten-thousandth of that of sound all is linear.
  const StepSearch search{.low = 0.1 * a_length, .high = 8 * a_length, .speed_limit = 1e-4 * c};
  const SolverWith solver_with = [&](double time_step) {
    return simulate(method.on, lattice, noisy(lattice, 1e-8), time_step * c / lattice.unit());
  };
  const CriticalStep found = critical_step(solver_with, search);
  const double own = method.on(lattice, {}).time_step(lattice.level()) / a_length,
               limit = std::sqrt(found.low * found.high) / a_length,
               linear = critical_courant(method.for_theory(), lattice, method.every);
  const double beyond = 1.05 * limit, growth = growth_per_step(solver_with(beyond * a_length), search),
               linear_growth = spectrum(method.for_theory(), lattice, beyond, method.every).radius;
  Run run = run_of_trials(meter, lattice.particles(), 0, found.steps);
  run.summary.time_step = found.low;
  run.add(measured, limit);
  run.add(by_theory, linear);
  run.add(measured_over_theory, limit / linear);
  if (is_leapfrog(method.name()))
    run.add(measured_over_criterion, limit / reference::quintic_leapfrog(lattice.across()).largest_stable_courant());
  run.add(growth_by_theory, linear_growth);
  if (std::isfinite(growth)) {
    run.add(growth_seen, growth);
    run.add(growth_over_theory, std::log(growth) / std::log(linear_growth));
  }
  run.add(step_chosen, own / limit);
  return run;
}

Method limits_of(const LatticeMethod& on_lattice) {
  Method method = on_lattice.on({}, {});
  method.tolerance = moved_limit;
  method.claims = {between(measured_over_theory, 0.95, 1.05, theory("the spectral radius of its own linearised step")),
                   chosen_is_stable};
  if (is_leapfrog(method.name))
    method.claims.push_back(between(measured_over_criterion, 0.99, 1.01,
                                    literature("Violeau & Leroy 2014: omega dt is at most 2, of the sums' own waves")));
  // Half of an artificial viscosity is too little to tell how fast a slow growth is, and so is one side of the kinks
  // that weights of GIMP have where a particle's edge lies on a node.
  if (!on_lattice.linear && !on_lattice.at_night_only)
    method.claims.push_back(between(growth_over_theory, 0.9, 1.1,
                                    theory("the same; measured from noise in which other modes grow as well")));
  std::vector<NamedRun> runs;
  for (const Arrangement& a : arrangements(on_lattice))
    runs.push_back({a.lattice.level(a.name, a.in_acceptance),
                    [=](const Level&, const Schedule&) { return compare(on_lattice, a.lattice); }});
  return with_runs(std::move(method), std::move(runs));
}

std::vector<LatticeMethod> methods_and_parts() {
  std::vector<LatticeMethod> all = methods_of_any_precision();
  std::ranges::copy(parts_on_lattice(), std::back_inserter(all));
  return all;
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Largest stable time step: simulation and linear stability theory",
      .description =
          "Fluid at rest on a doubly periodic lattice, with noise of 1e-8 times the speed of sound. "
          "The largest time step for which it stays small is found by bisection, 2000 steps each, and compared with linear "
          "stability theory: the implemented step of the method, linearised and decomposed into Fourier modes, and the "
          "largest eigenvalue of all: agreement shows that runs do what the step says, not that the step is right. Where a "
          "closed criterion that does not know the code holds, SPH by kick-drift-kick without dissipation (Violeau & "
          "Leroy 2014), it is asked, too. There is no wall, no free surface and no flow here: the result is a property of the method "
          "alone.",
      .times = {1},
      .measurements = {},
      .methods = each_of(methods_and_parts(), limits_of),
      .plots = {limits_table(
          "Largest stable step, measured and by linear theory",
          "As acoustic Courant numbers, based on cells in MPM and on spacings in SPH. The Courant limit (31) of Sun et "
          "al. is 1 cell or h. Growth is that of the fastest particle's speed per step at 1.05 times the largest "
          "stable step. The chosen step is what the method takes where the scene prescribes none.",
          "arrangement",
          {{"measured", measured},
           {"theory", by_theory},
           {"measured / theory", measured_over_theory},
           {"measured / criterion", measured_over_criterion},
           {"growth", growth_seen},
           {"growth by theory", growth_by_theory},
           {"chosen / measured", step_chosen}})},
      .label = "stability",
  };
}
