/// The largest stable time step of each method in periodic flows, compared with linear theory for fluid at rest.

#include "vnv/stability/critical_step.hpp"
#include "vnv/stability/lattice_starts.hpp"
#include "vnv/stability/methods_on_lattice.hpp"
#include "vnv/stability/spectrum.hpp"

using namespace touchstone;
using namespace touchstone::vnv;

namespace {

const Quantity over_theory{"largest stable time step over that of linear theory at rest", "", Kind::stability_limit};

/// A flow through a lattice that repeats along both axes.
struct PeriodicFlow {
  std::string name;
  Vec2 carried;         // speeds of sound
  double shear;         // speeds of sound  amplitude of a wave of velocity along x, one wave up the lattice
  double noise, limit;  // speeds of sound  initial perturbation, and the speed at which a run counts as diverged
};

const std::vector<PeriodicFlow> flows = {
    {"uniform flow", {0.1, 0.037}, 0, 1e-8, 1e-4},
    {"shear wave", {0, 0}, 0.02, 1e-6, 0.06},
};

RestingLattice lattice_for(const LatticeMethod& method) {
  RestingLattice lattice = method.usual_lattice(12);
  lattice.reynolds = 1e3;
  return lattice;
}

Start start_of(const PeriodicFlow& flow, const RestingLattice& lattice) {
  return noisy(lattice, flow.noise, [flow, side = lattice.side()](const Vec2& x) -> Vec2 {
    return RestingLattice::sound_speed * (flow.carried + Vec2(flow.shear * wave_at(x.y(), side), 0));
  });
}

Run search_in(const PeriodicFlow& flow, const LatticeMethod& method) {
  const RestingLattice lattice = lattice_for(method);
  const double c = RestingLattice::sound_speed, a_length = lattice.unit() / c;
  const StepSearch search{
      .low = 0.1 * a_length, .high = 8 * a_length, .speed_limit = flow.limit * c, .carried = flow.carried * c};
  Run run = search_critical_step(
      [&](double time_step) { return simulate(method.on, lattice, start_of(flow, lattice), time_step / a_length); },
      search, lattice.unit(), c);
  const double linear = critical_courant(method.for_theory(), lattice, method.every);
  run.add(over_theory, run.summary.time_step / a_length / linear);
  run.add(step_chosen, method.on(lattice, {}).time_step(lattice.level()) / run.summary.time_step);
  return run;
}

Method limits_of(const LatticeMethod& on_lattice) {
  Method method = on_lattice.on({}, {});
  method.tolerance = moved_limit;
  method.claims = {chosen_is_stable.on("shear wave")};
  if (on_lattice.claims_to_be_galilean)
    method.claims.push_back(
        between(over_theory, 0.95, 1.05, theory("Galilean invariance: the limit is that at rest")).on("uniform flow"));
  std::vector<NamedRun> runs;
  for (const PeriodicFlow& flow : flows)
    runs.push_back({lattice_for(on_lattice).level(flow.name, true),
                    [=](const Level&, const Schedule&) { return search_in(flow, on_lattice); }});
  return with_runs(std::move(method), std::move(runs));
}

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Largest stable time step in uniform flow and in a shear wave",
      .description =
          "Doubly periodic fluid is advected at a tenth of the speed of sound, or sheared by a velocity wave with an "
          "amplitude of a fiftieth of it. The largest step is found by bisection, 2000 steps a trial; a trial is unstable when "
          "a particle exceeds any velocity of the exact flow. The spacing is 1 cm, the speed of sound 10 m/s.",
      .times = {1},
      .measurements = {},
      .methods = each_of(methods_on_lattice(), limits_of),
      .plots = {limits_table("Largest stable step in each flow", words_of_limits, "flow",
                             {{"stable [us]", stable_end},
                              {"unstable [us]", unstable_end},
                              {"stable, c dt / length", over_courant},
                              {"over theory at rest", over_theory},
                              {"chosen / largest stable", step_chosen},
                              {"growth", growth_beyond}})},
      .label = "stability",
  };
}
